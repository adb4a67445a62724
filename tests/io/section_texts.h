#pragma once
/// Small sections written by hand.

#include <string>

namespace section_texts {

/// Two parallel squares; line 3 holds the counts of plane 0, line 13 the equation of plane 1.
inline const std::string kTwoSquares =
    "2\n"
    "0 0 1 0\n"
    "4 4\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    "0 1 1 0\n1 2 1 0\n2 3 1 0\n3 0 1 0\n"
    "\n"
    "0 0 2 -2\n"
    "4 4\n"
    "0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
    "0 1 1 0\n1 2 1 0\n2 3 1 0\n3 0 1 0\n";

/// A square with a square hole and an island in it, and an empty plane. Line 4 is plane 0, 18 to 20 its
/// components.
inline const std::string kSquareWithHole =
    "CSLC\n"
    "2 2\n"
    "\n"
    "1 12 3 0 0 1 -5\n"
    "\n"
    "0 0 5\n9 0 5\n9 9 5\n0 9 5\n"
    "1 1 5\n8 1 5\n8 8 5\n1 8 5\n"
    "2 2 5\n7 2 5\n7 7 5\n2 7 5\n"
    "4 1 0 1 2 3\n"
    "4h0 2 7 6 5 4\n"
    "4 1 8 9 10 11\n"
    "\n"
    "2 0 0 0 0 1 -6\n";

}  // namespace section_texts
