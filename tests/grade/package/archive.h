// What the sources of files have in common: a folder, an archive.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rt::grade
{

inline constexpr std::size_t largestExercise = std::size_t(256) << 10;
inline constexpr std::size_t largestPackage = std::size_t(64) << 20;
inline constexpr int mostEntries = 10'000;

/// The package is refused; what() is one sentence without a full stop.
struct Refused : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

struct PackedFile
{
    std::string path; ///< relative, as it stands in the package
    std::string bytes;
};

/// The regular files whose path `isWanted`; throws Refused.
std::vector<PackedFile> filesInArchive(const std::string& path, const std::function<bool(const std::string&)>& isWanted,
                                       std::vector<std::string>& remarks);
std::vector<PackedFile> filesInFolder(const std::string& path, const std::function<bool(const std::string&)>& isWanted,
                                      std::vector<std::string>& remarks);

/// A single file.
std::string bytesOf(const std::string& path);

} // namespace rt::grade
