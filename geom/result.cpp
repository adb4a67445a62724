#include "result.h"

namespace crossloft {

std::string to_string(const Error& error) {
  std::string text = error.file;
  if (error.line != 0) text += (text.empty() ? "line " : ":") + std::to_string(error.line);
  if (!text.empty()) text += ": ";
  if (error.plane != kNone) {
    text += "plane " + std::to_string(error.plane);
    text += error.contour != kNone ? ", contour " + std::to_string(error.contour) + ": " : ": ";
  }
  return text + error.message;
}

}  // namespace crossloft
