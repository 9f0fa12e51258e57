#pragma once

namespace hsr::lanes {

// The error bounds of the fast versions, all in one place.
//
// A fast version evaluates edge functions and 1/depth in floats, many lanes at once, and believes a sign only
// where it is certain. Here is why it may. v = 2^-53 and u = 2^-24 are half the distance from 1 to the next
// double and float: rounding to nearest changes a result x by at most v |x| or u |x|. Fused operations round
// less often than counted here.
//
//   Input. The rows M_x, M_y, M_w of clip_from_world and the positions p are exact. The rows
//     R_x = (M_x + M_w) W/2,  R_y = (M_w - M_y) H/2,  R_w = M_w
//   give X = raster_x · depth, Y = raster_y · depth and w = depth. R_x and R_y carry two roundings, R_w none.
//   An origin q is a pixel's centre, and all that follows is in x = X - q_x w, y = Y - q_y w. Let o be at
//   least every origin coordinate and every offset (RasterView::reach), and
//     N_j = max(|R_xj|, |R_yj|) + o |R_wj|          (RasterView::magnitude).
//
//   Corners. c = R p for corner 0, and d_1, d_2 = R (p_k - p_0), linear part only. With
//     F = Σ N_j |p_0j| + N_3,    G = Σ N_j max(|p_1j - p_0j|, |p_2j - p_0j|)
//   we have |x|, |y| <= F and |w| <= F/o for c, and G in place of F for d. Errors: a term of X has 2
//   roundings from R, 1 from its product, up to 3 from sums (for d: 2 from sums, 1 from the difference of
//   positions): 6 v. A term of w has 4 v. Subtracting q_x w adds 1 v for the product and 1 v for the
//   difference, both bounded by F (or G). To first order and rounded up:
//     x, y of c: 7.1 v F    w of c: 4.1 v F/o    x, y of d: 7.1 v G    w of d: 4.1 v G/o.
//
//   Edges. e_2 = c × d_1, e_1 = d_2 × c, s = d_1 × d_2, e_0 = s - e_1 - e_2: these are the cross products of
//   Olano and Greer (corner 1 = c + d_1, corner 2 = c + d_2), and s is the sum of the three. The first or
//   second component of a cross product of vectors with bounds A and B (F or G_k), such as y w' - w y', errs
//   by (7.1 + 4.1 + 7.1 + 4.1) v A B/o from its operands and by 4 v A B/o from its own three roundings:
//   26.5 v A B/o. The third errs by (4 · 7.1 + 4) v A B: 32.5 v A B. At an offset of at most o in x and in y
//   this makes (26.5 + 26.5 + 32.5) v A B <= 86 v A B. For e_0 the errors of the three add up, and its two
//   subtractions round by 2 v times the sizes of the three, which at an offset are at most 6 A B each. With
//     P_2 = F G_1,  P_1 = F G_2,  P_0 = G_1 G_2 + P_1 + P_2
//   edge k errs by at most
//     edge_error v P_k.
//
//   Determinant. det = c · s. Each of its products errs by (26.5 + 2 · 7.1) v F G_1 G_2/o in x and y and by
//   (32.5 + 2 · 4.1) v F G_1 G_2/o in w; the sum's roundings are within 3 v · 6 F G_1 G_2/o. That makes 141,
//   so
//     determinant_error v F G_1 G_2/o.
//   It must be smaller than |det| / least_certainty, or the triangle is not for the filter: its orientation
//   might be wrong. ρ = that error / |det| is then at most 2^-10.
//
//   Floats. A plane A x + B y + C is rounded to floats and evaluated at whole offsets 0 <= x <= D_x,
//   0 <= y <= D_y in any order in which no term is rounded more than `float_roundings` times, its own
//   coefficient's rounding included. Every intermediate result is at most m = |A| D_x + |B| D_y + |C|, so the
//   value errs by
//     float_error u m.
//   0.002 u m of it is for squares of u, and 0.008 u m for the few roundings in double on the way (2^-28 u
//   m).
//
//   Coverage. ε_k = edge_error v P_k + float_error u m, and edge k is divided by it with the sign of det
//   before it is rounded to floats. Then a value >= 1 is certainly inside or on the edge, a value < -1
//   certainly outside, and anything between is for the exact predicates. As 1/ε <= 1/(float_error u m), no
//   float overflows, and what underflows (64 · 2^-149) is nothing to the 2 % that edge_error leaves over.
//
//   Depth. 1/depth = s · p / det. It errs by 86 v G_1 G_2 / |det| from s, by 1.001 m ρ / |det| from det
//   (1.001 covers 1/(1 - ρ)), and by float_error u m / |det| from floats, m taken of s. So with m of s
//     ζ = ((float_error u + 1.01 ρ) m + depth_error v G_1 G_2) / |det|.
//   All of it is multiplied by RasterView::depth_scale, a power of two, so that 1/depth is at most 2 where it
//   is seen. Of two surfaces the one with the greater 1/depth is certainly nearer if the floats differ by
//   more than (ζ_1 + ζ_2) comparison_slack: the subtraction, the sum and rounding ζ to float take 4 u of it.
//   smallest_depth_error keeps ζ above what underflow of floats can lose.
//
//   In doubles the same 1/depth errs by double_error v m / |det| in place of float_error u m / |det|: the
//   plane comes from s and det by a division and a product, and is evaluated with four roundings more.
//
//   Range. Products of F and G_k must neither underflow nor overflow: all must lie in [2^-300, 2^300], or the
//   triangle is not for the filter. Products that underflow nevertheless (differences that cancel) lose
//   2^-1074, which is nothing to v F G_1 >= 2^-653.
//
// F, G_k, m, ε and ζ are computed in double themselves, with a few relative errors of v: the last digits of
// the constants are rounded up for that.

inline constexpr double v = 0x1p-53;
inline constexpr double u = 0x1p-24;
inline constexpr int float_roundings = 5;
inline constexpr double float_error = 5.01;
inline constexpr double double_error = 8.0;
inline constexpr double edge_error = 100.0;
inline constexpr double depth_error = 90.0;
inline constexpr double determinant_error = 150.0;
inline constexpr double least_certainty = 1024.0;
inline constexpr double least_magnitude = 0x1p-300;
inline constexpr double greatest_magnitude = 0x1p300;
inline constexpr double smallest_depth_error = 0x1p-140;
inline constexpr float comparison_slack = 1.0F + 0x1p-20F;

}  // namespace hsr::lanes
