#pragma once
/// What reports say to the user, in the same words of a whole and of a stack in windows.

#include <cstddef>
#include <string>

namespace crossloft {

/// Of a surface without triangles, by the number of planes with a section.
std::string why_empty(std::size_t filled);
/// Of section regions that are bare on both sides.
std::string tell_flats(std::size_t regions);
/// Of faces that have a triangulation only without the samples that were wanted.
std::string tell_unsampled(std::size_t faces);
/// Of vertices that took the places of others.
std::string tell_merged(std::size_t vertices);
/// Of copies with too much around them to be moved apart.
std::string tell_crowded(std::size_t copies);
/// Of triangles that touch though all was tried, at so many copies.
std::string tell_contacts(std::size_t pairs, std::size_t copies);

}  // namespace crossloft
