// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/index.hpp"

namespace crumple::output {

/// One array of a VTK file, already packed as the file wants it, so that arrays that never change are
/// compressed once for all frames.
struct VtuArray {
  std::string name;
  std::string type;    ///< VTK's name of the number type: "Float32", "Int32", ...
  int components = 1;  ///< numbers per tuple
  std::string packed;  ///< block header and zlib streams
};

template <class T>
std::string_view vtk_type_name();
template <>
inline std::string_view vtk_type_name<float>() {
  return "Float32";
}
template <>
inline std::string_view vtk_type_name<std::int32_t>() {
  return "Int32";
}
template <>
inline std::string_view vtk_type_name<std::int64_t>() {
  return "Int64";
}
template <>
inline std::string_view vtk_type_name<std::uint8_t>() {
  return "UInt8";
}

/// Packs arrays. Keeps zlib's working memory from one array to the next: asking the system for it anew each
/// time costs more than packing a small array.
class VtuPacker {
 public:
  VtuPacker();
  ~VtuPacker();
  VtuPacker(VtuPacker&&) noexcept;
  VtuPacker& operator=(VtuPacker&&) noexcept;

  /// Header (number of blocks, block size, size of a short last block, compressed sizes, all 64-bit) followed
  /// by one zlib stream per block: VTK's appended raw form with a compressor (VTK File Formats, "XML File
  /// Formats", appended data). Throws WriteError if there is no memory.
  std::string pack(std::string_view bytes);

  template <class T>
  VtuArray array(std::string name, int components, std::span<const T> values) {
    const auto bytes = std::as_bytes(values);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return {std::move(name), std::string(vtk_type_name<T>()), components, pack(text)};
  }

 private:
  void append_block(std::string& data, std::string_view bytes);

  struct Stream;
  std::unique_ptr<Stream> stream_;
};

/// An unstructured grid at one time, in VTK's terms.
struct VtuGrid {
  double time = 0;
  Index points = 0;
  Index cells = 0;
  std::vector<const VtuArray*> positions;   ///< one array of three components
  std::vector<const VtuArray*> topology;    ///< connectivity, offsets, types
  std::vector<const VtuArray*> point_data;  ///< one tuple per point
  std::vector<const VtuArray*> cell_data;   ///< one tuple per cell
};

/// The whole text of a `.vtu` file: appended raw data, zlib, 64-bit headers.
std::string vtu_text(const VtuGrid& grid);

}  // namespace crumple::output
