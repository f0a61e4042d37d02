#include "core/import/compression.h"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "core/base/say.h"

namespace heft {

namespace {

constexpr std::size_t kBlock = 256u << 10;

Unpacked unpackBz2(std::string_view packed, std::size_t maxBytes, const Progress& progress) {
  Unpacked out;
  bz_stream stream{};
  if (packed.size() > std::numeric_limits<unsigned>::max() || BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) return out;
  std::string block(kBlock, '\0');
  stream.next_in = const_cast<char*>(packed.data());  // the library does not write to it
  stream.avail_in = static_cast<unsigned>(packed.size());
  while (!progress.cancelled()) {
    stream.next_out = block.data();
    stream.avail_out = static_cast<unsigned>(block.size());
    const int state = BZ2_bzDecompress(&stream);
    const std::size_t got = block.size() - stream.avail_out;
    if (!out.add(std::string_view(block).substr(0, got), maxBytes)) break;
    out.complete = state == BZ_STREAM_END;
    if (state != BZ_OK || (got == 0 && stream.avail_in == 0)) break;
  }
  BZ2_bzDecompressEnd(&stream);
  return out;
}

Unpacked unpackLz4(std::string_view packed, std::size_t maxBytes, const Progress& progress) {
  Unpacked out;
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0) return out;
  std::string block(kBlock, '\0');
  while (!packed.empty() && !progress.cancelled()) {
    std::size_t got = block.size();
    std::size_t used = packed.size();
    const std::size_t state = LZ4F_decompress(context, block.data(), &got, packed.data(), &used, nullptr);
    if (LZ4F_isError(state) != 0 || !out.add(std::string_view(block).substr(0, got), maxBytes)) break;
    packed.remove_prefix(used);
    out.complete = state == 0;
    if (out.complete || (used == 0 && got == 0)) break;
  }
  LZ4F_freeDecompressionContext(context);
  return out;
}

Unpacked unpackZstd(std::string_view packed, std::size_t maxBytes, const Progress& progress) {
  Unpacked out;
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(), &ZSTD_freeDCtx);
  if (!context) return out;
  std::string block(kBlock, '\0');
  ZSTD_inBuffer input{packed.data(), packed.size(), 0};
  while (!progress.cancelled()) {
    ZSTD_outBuffer output{block.data(), block.size(), 0};
    const std::size_t state = ZSTD_decompressStream(context.get(), &output, &input);
    if (ZSTD_isError(state) != 0 || !out.add(std::string_view(block).substr(0, output.pos), maxBytes)) {
      out.complete = false;
      break;
    }
    out.complete = state == 0;
    // A file may hold several frames one after the other. A last block may fill the buffer to the end.
    if (input.pos == input.size && (state == 0 || output.pos < output.size)) break;
  }
  return out;
}

}  // namespace

std::string budgetText(std::uint64_t fileSize) {
  return heft::say("The file of {} kB unpacks to more than 64 times its size and 1 GB; the rest was not read.",
                   (fileSize + 1023) >> 10);
}

Unpacked unpack(std::string_view packed, Compression compression, std::size_t maxBytes, const Progress& progress) {
  switch (compression) {
    case Compression::none:
      return {std::string(packed), true};
    case Compression::bz2:
      return unpackBz2(packed, maxBytes, progress);
    case Compression::lz4:
      return unpackLz4(packed, maxBytes, progress);
    case Compression::zstd:
      return unpackZstd(packed, maxBytes, progress);
  }
  return {};
}

bool looksLikeZstd(std::string_view bytes) { return bytes.starts_with("\x28\xB5\x2F\xFD"); }

}  // namespace heft
