// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/finishpdf.h"

#include "kernel/numerics/runinbackground.h"

#include <libdeflate.h>
#include <memory>
#include <new>
#include <utility>

namespace palmer {

namespace {

constexpr qsizetype isLong = qsizetype(4) << 20U;

using Compressor = std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)>;

Compressor madeCompressor(int level) {
    return {libdeflate_alloc_compressor(level), &libdeflate_free_compressor};
}

QByteArray packedBy(libdeflate_compressor *compressor, const QByteArray &bytes) {
    if (!compressor)
        throw std::bad_alloc();
    const auto size = static_cast<std::size_t>(bytes.size());
    const std::size_t most = libdeflate_zlib_compress_bound(compressor, size);
    QByteArray result(static_cast<qsizetype>(most), Qt::Uninitialized);
    result.resize(static_cast<qsizetype>(
        libdeflate_zlib_compress(compressor, bytes.constData(), size, result.data(), most)));
    result.squeeze();
    return result;
}

} // namespace

QByteArray pack(const QByteArray &bytes) {
    constexpr int quickest = 1;
    if (bytes.size() > isLong)
        return packedBy(madeCompressor(quickest).get(), bytes);
    constexpr int usual = 6;
    thread_local const Compressor forPages = madeCompressor(usual); // making it takes as long as a page
    return packedBy(forPages.get(), bytes);
}

std::shared_future<QByteArray> packed(const QByteArray &bytes) {
    return runInBackground(bytes.size() > isLong, [kept = bytes]() mutable {
        const QByteArray own = std::exchange(kept, {}); // the future keeps what it ran
        return pack(own);
    });
}

} // namespace palmer
