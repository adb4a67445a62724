#pragma once
/// Sine and cosine from + - * / alone, the same on every platform; the C library's are not.

#include <cmath>

namespace crossloft {

struct SineCosine {
  double sine = 0, cosine = 1;
};

/// Of 2 pi turns, for |turns| <= 2^20. Exact at multiples of a quarter turn, else the
/// error is below 4e-16. Taylor series on [0, pi/4]: the first term left out is below 1e-17.
inline SineCosine circle(double turns) {
  const double whole = std::floor(turns);
  const double eighths = 8 * (turns - whole);
  const int octant = static_cast<int>(eighths) & 7;
  const double part = eighths - static_cast<double>(static_cast<int>(eighths));
  const double x = 0.78539816339744830962 * (octant % 2 == 0 ? part : 1 - part), y = x * x;
  double sine = 0, cosine = 0;
  for (int k = 16; k >= 2; k -= 2) {
    sine = y / (k * (k + 1)) * (1 - sine);
    cosine = y / (k * (k - 1)) * (1 - cosine);
  }
  sine = x * (1 - sine);
  cosine = 1 - cosine;
  switch (octant) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, sine};
    case 2:
      return {cosine, -sine};
    case 3:
      return {sine, -cosine};
    case 4:
      return {-sine, -cosine};
    case 5:
      return {-cosine, -sine};
    case 6:
      return {-cosine, sine};
    default:
      return {-sine, cosine};
  }
}

}  // namespace crossloft
