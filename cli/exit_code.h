#pragma once
/// What the program tells its caller.

#include "../geom/result.h"

namespace crossloft::cli {

enum ExitCode : int {
  kGood = 0,
  kPromiseBroken = 1,  ///< the program worked, and what it looked at does not hold a promise
  kUsage = 2,          ///< an argument makes no sense
  kBadFile = 3,        ///< a file is not readable, not valid or not writable
  kInternal = 4,       ///< a defect of the program, or no memory left
  kInterrupted = 130,  ///< Ctrl-C
};

constexpr ExitCode exit_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::usage:
      return kUsage;
    case ErrorCode::cancelled:
      return kInterrupted;
    case ErrorCode::internal:
    case ErrorCode::out_of_memory:
      return kInternal;
    default:
      return kBadFile;
  }
}

}  // namespace crossloft::cli
