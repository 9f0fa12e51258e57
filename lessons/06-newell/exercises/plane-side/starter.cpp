#include "exercise.h"

// Whether every corner of p lies behind the plane of q, or in it. The eye is at (0, 0, 0).
bool lies_behind(const Triangle& p, const Triangle& q) {
  // On which side of q's plane is the eye? On which side are the corners of p?
  return true;  // as if nothing ever had to be exchanged
}
