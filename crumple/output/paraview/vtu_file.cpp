// SPDX-License-Identifier: BSD-3-Clause
#include "output/paraview/vtu_file.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>

#include "output/files/write_error.hpp"

namespace crumple::output {

namespace {

constexpr std::size_t block_size = 1U << 18;

void append_number(std::string& text, std::uint64_t number) {
  char bytes[sizeof(number)];
  std::memcpy(bytes, &number, sizeof(number));
  text.append(bytes, sizeof(number));
}

/// Writes the XML head of the arrays of one section; the data itself follows later, at `offset`.
void add_section(std::string& xml, std::string_view section, const std::vector<const VtuArray*>& arrays,
                 std::uint64_t& offset) {
  fmt::format_to(std::back_inserter(xml), "      <{}>\n", section);
  for (const VtuArray* array : arrays) {
    offset -= array->packed.size();
    fmt::format_to(std::back_inserter(xml),
                   "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
                   "offset=\"{}\"/>\n",
                   array->type, array->name, array->components, offset);
  }
  fmt::format_to(std::back_inserter(xml), "      </{}>\n", section);
}

}  // namespace

struct VtuPacker::Stream {
  z_stream zlib{};
  bool ready = false;
};

VtuPacker::VtuPacker() : stream_(std::make_unique<Stream>()) {
  // The fastest level: fields of floats hardly gain from more effort, and the run waits for it.
  stream_->ready = deflateInit(&stream_->zlib, Z_BEST_SPEED) == Z_OK;
  if (!stream_->ready) throw WriteError("zlib could not be started: out of memory.");
}

VtuPacker::~VtuPacker() {
  if (stream_ && stream_->ready) deflateEnd(&stream_->zlib);
}

VtuPacker::VtuPacker(VtuPacker&&) noexcept = default;
VtuPacker& VtuPacker::operator=(VtuPacker&&) noexcept = default;

void VtuPacker::append_block(std::string& data, std::string_view bytes) {
  z_stream& zlib = stream_->zlib;
  deflateReset(&zlib);
  const std::size_t start = data.size();
  data.resize(start + deflateBound(&zlib, bytes.size()));
  // zlib does not write to its input, but its interface lacks the const.
  zlib.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  zlib.avail_in = static_cast<uInt>(bytes.size());
  zlib.next_out = reinterpret_cast<Bytef*>(data.data() + start);
  zlib.avail_out = static_cast<uInt>(data.size() - start);
  if (deflate(&zlib, Z_FINISH) != Z_STREAM_END) throw WriteError("zlib could not compress a field.");
  data.resize(start + zlib.total_out);
}

std::string VtuPacker::pack(std::string_view bytes) {
  const std::size_t blocks = (bytes.size() + block_size - 1) / block_size;
  std::string header;
  append_number(header, blocks);
  append_number(header, block_size);
  append_number(header, bytes.size() % block_size);
  std::string data;
  for (std::size_t at = 0; at < bytes.size(); at += block_size) {
    const std::size_t start = data.size();
    append_block(data, bytes.substr(at, block_size));
    append_number(header, data.size() - start);
  }
  return header + data;
}

std::string vtu_text(const VtuGrid& grid) {
  const std::string_view order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\" "
      "compressor=\"vtkZLibDataCompressor\">\n"
      "  <UnstructuredGrid>\n"
      "    <FieldData>\n"
      "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}"
      "</DataArray>\n"
      "    </FieldData>\n"
      "    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
      order, grid.time, grid.points, grid.cells);
  // The data stand in reverse: meshio looks for the array of an offset among tags whose offsets it has
  // changed, and only so the first that it finds is the one.
  std::string data;
  for (const auto* arrays : {&grid.topology, &grid.positions, &grid.cell_data, &grid.point_data})
    for (auto array = arrays->rbegin(); array != arrays->rend(); ++array) data += (*array)->packed;
  std::uint64_t offset = data.size();
  add_section(text, "PointData", grid.point_data, offset);
  add_section(text, "CellData", grid.cell_data, offset);
  add_section(text, "Points", grid.positions, offset);
  add_section(text, "Cells", grid.topology, offset);
  text += "    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_";
  text += data;
  text += "\n  </AppendedData>\n</VTKFile>\n";
  return text;
}

}  // namespace crumple::output
