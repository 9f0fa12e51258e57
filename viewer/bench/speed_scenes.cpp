#include "bench/speed_scenes.h"

#include <array>

namespace hsr::bench {

std::span<const SpeedScene> speed_scenes() {
  static constexpr std::array rows = {
      SpeedScene{"sphere70k", "bumpy-sphere:76", "a closed mesh of 69,312 small triangles", true},
      SpeedScene{"sphere1M", "bumpy-sphere:289", "a million triangles, most of them smaller than a pixel",
                 true},
      SpeedScene{"soup100k", "soup:100000", "a hundred thousand triangles, twenty layers deep", true},
      SpeedScene{"big100", "big-soup:100", "a hundred large triangles that cross each other", true},
      SpeedScene{"cube12", "cube", "twelve triangles: what a picture costs at least", true},
      SpeedScene{"duplicate-cube", "duplicate-cube", "every pixel a tie", false},
      SpeedScene{"aligned-grid", "aligned-grid:79:13:1080", "corners and edges on pixel centres", false},
      SpeedScene{"far-1000", "far-away:10:76", "sphere70k's mesh, moved 1,024 units away from the origin",
                 false},
      SpeedScene{"far-30000", "far-away:15:76", "the same, moved 32,768 units away", false},
      SpeedScene{"far-vertex", "one-cell:1000:76", "the same beside a triangle with one far corner", false},
      SpeedScene{"inside-soup", "inside-soup:20000", "the eye inside the soup, corners behind it", false},
      SpeedScene{"needles", "needles:1000:20000", "long thin triangles", false},
      SpeedScene{"woven", "woven:60", "cycles everywhere", false},
      SpeedScene{"behind-a-wall", "behind-a-wall:76", "nine tenths of the triangles hidden", false},
  };
  return rows;
}

}  // namespace hsr::bench
