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

} // namespace

QByteArray pack(const QByteArray &bytes) {
    constexpr int quickest = 1;
    constexpr int usual = 6;
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(bytes.size() > isLong ? quickest : usual), &libdeflate_free_compressor);
    if (!compressor)
        throw std::bad_alloc();
    const auto size = static_cast<std::size_t>(bytes.size());
    const std::size_t most = libdeflate_zlib_compress_bound(compressor.get(), size);
    QByteArray result(static_cast<qsizetype>(most), Qt::Uninitialized);
    result.resize(static_cast<qsizetype>(
        libdeflate_zlib_compress(compressor.get(), bytes.constData(), size, result.data(), most)));
    return result;
}

std::shared_future<QByteArray> packed(const QByteArray &bytes) {
    return runInBackground(bytes.size() > isLong, [kept = bytes]() mutable {
        const QByteArray own = std::exchange(kept, {}); // the future keeps what it ran
        return pack(own);
    });
}

} // namespace palmer
