#include "predicates.h"

#include "double_filters.h"

namespace crossloft {

int orient2d(Vec2 a, Vec2 b, Vec2 c) {
  if (const int sign = orient2d_filter(a, b, c)) return sign;
  return orient2d_after_filter(a, b, c);
}

int orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  if (const int sign = orient3d_filter(a, b, c, d)) return sign;
  return orient3d_after_filter(a, b, c, d);
}

int incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (const int sign = incircle_filter(a, b, c, d)) return sign;
  return incircle_after_filter(a, b, c, d);
}

int insphere(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 e) {
  if (const int sign = insphere_filter(a, b, c, d, e)) return sign;
  return insphere_after_filter(a, b, c, d, e);
}

}  // namespace crossloft
