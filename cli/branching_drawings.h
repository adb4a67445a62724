#pragma once
/// The drawings of `reconstruct --dump-branching DIR`: one for each side of a face that has a branching
/// diagram.

#include <string>
#include <utility>
#include <vector>

#include "../io/write_face_svg.h"
#include "../reconstruct/observer.h"

namespace crossloft::cli {

/// Collects the drawings while a reconstruction runs, writes them when it has succeeded.
class BranchingDrawings : public Observer {
 public:
  void on_sections(const FramedSections& framed, const Arrangement& arrangement,
                   const SectionGraph& graph) override;
  void on_branching(const FaceBranching& branching, const FaceTriangulation& face,
                    const Numbering& numbering) override;

  std::size_t size() const { return drawings_.size(); }
  /// Into the folder, which is made if it is not there: plane<P>-face<F>-<above|below>.svg, P the plane's
  /// position in the file, F the face in the arrangement. Errors: file_not_writable.
  Result<Done> write(const std::string& folder) const;

 private:
  std::vector<std::uint32_t> sources_;                         ///< by plane: its position in the file
  std::vector<std::vector<Vec3>> outlines_;                    ///< by face: its corners
  std::vector<std::pair<std::string, FaceDrawing>> drawings_;  ///< by file name
};

/// Whether drawings can be written into the folder: it is there and writable, or can be made. Errors:
/// file_not_writable.
Result<Done> check_folder(const std::string& folder);

}  // namespace crossloft::cli
