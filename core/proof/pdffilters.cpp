// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/pdffilters.h"

#include <qpdf/Pl_Flate.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFStreamFilter.hh>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <vector>

namespace palmer {

namespace {

constexpr std::int64_t unbounded = std::numeric_limits<std::int64_t>::max();
thread_local std::int64_t room = unbounded; // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

class Bounded : public Pipeline {
public:
    explicit Bounded(Pipeline *to)
        : Pipeline("bounded", to) {}

    void write(const unsigned char *data, std::size_t size) override {
        if (room == unbounded) {
            getNext()->write(data, size);
            return;
        }
        room -= static_cast<std::int64_t>(size);
        if (room < 0)
            throw std::runtime_error("unpacks to more than is read");
        getNext()->write(data, size);
    }
    void finish() override { getNext()->finish(); }
};

struct Predictor {
    std::size_t rowBytes = 0;
    std::size_t pixelBytes = 1;
};

/// Undoes PNG predictors, row by row (ISO 32000-1, 7.4.4.4).
class PngRows : public Pipeline {
public:
    PngRows(Pipeline *to, Predictor predictor)
        : Pipeline("rows", to)
        , m_pixelBytes(predictor.pixelBytes)
        , m_above(predictor.rowBytes)
        , m_row(predictor.rowBytes) {}

    void write(const unsigned char *data, std::size_t size) override {
        for (std::size_t i = 0; i < size; ++i) {
            if (!m_inRow) {
                m_kind = data[i];
                m_inRow = true;
                m_filled = 0;
            } else {
                m_row[m_filled] = data[i];
                ++m_filled;
            }
            if (m_inRow && m_filled == m_row.size())
                endRow();
        }
    }
    void finish() override {
        if (m_inRow && m_filled > 0) {
            std::fill(m_row.begin() + static_cast<std::ptrdiff_t>(m_filled), m_row.end(), std::uint8_t(0));
            endRow();
        }
        getNext()->finish();
    }

private:
    void endRow() {
        for (std::size_t i = 0; i < m_row.size(); ++i) {
            const int left = i >= m_pixelBytes ? m_row[i - m_pixelBytes] : 0;
            const int corner = i >= m_pixelBytes ? m_above[i - m_pixelBytes] : 0;
            m_row[i] = static_cast<std::uint8_t>(m_row[i] + predicted(left, m_above[i], corner));
        }
        getNext()->write(m_row.data(), m_row.size());
        m_above = m_row;
        m_inRow = false;
    }

    [[nodiscard]] int predicted(int left, int above, int corner) const {
        switch (m_kind) {
        case 1:
            return left;
        case 2:
            return above;
        case 3:
            return (left + above) / 2;
        case 4: {
            const int fromLeft = std::abs(above - corner);
            const int fromAbove = std::abs(left - corner);
            const int fromCorner = std::abs(left + above - 2 * corner);
            if (fromLeft <= fromAbove && fromLeft <= fromCorner)
                return left;
            return fromAbove <= fromCorner ? above : corner;
        }
        default:
            return 0;
        }
    }

    std::size_t m_pixelBytes;
    std::vector<std::uint8_t> m_above;
    std::vector<std::uint8_t> m_row;
    std::size_t m_filled = 0;
    int m_kind = 0;
    bool m_inRow = false;
};

long long numberOf(QPDFObjectHandle parameters, const char *key, long long otherwise) {
    const QPDFObjectHandle value = parameters.getKey(key);
    return QPDFObjectHandle(value).isInteger() ? QPDFObjectHandle(value).getIntValue() : otherwise;
}

class BoundedFlate : public QPDFStreamFilter {
public:
    bool setDecodeParms(QPDFObjectHandle parameters) override {
        if (parameters.isNull())
            return true;
        if (!parameters.isDictionary())
            return false;
        const long long predictor = numberOf(parameters, "/Predictor", 1);
        if (predictor == 1)
            return true;
        constexpr long long widest = 1 << 16;
        const long long columns = numberOf(parameters, "/Columns", 1);
        const long long colours = numberOf(parameters, "/Colors", 1);
        const long long bits = numberOf(parameters, "/BitsPerComponent", 8);
        if (predictor < 10 || predictor > 15 || columns < 1 || columns > widest || colours < 1 ||
            colours > 4 || (bits != 1 && bits != 2 && bits != 4 && bits != 8 && bits != 16))
            return false;
        m_predictor = {static_cast<std::size_t>((columns * colours * bits + 7) / 8),
                       static_cast<std::size_t>(std::max(1LL, colours * bits / 8))};
        return true;
    }

    Pipeline *getDecodePipeline(Pipeline *next) override {
        m_bounded = std::make_unique<Bounded>(next);
        Pipeline *last = m_bounded.get();
        if (m_predictor.rowBytes > 0) {
            m_rows = std::make_unique<PngRows>(last, m_predictor);
            last = m_rows.get();
        }
        m_flate = std::make_unique<Pl_Flate>("unpack", last, Pl_Flate::a_inflate);
        return m_flate.get();
    }

private:
    Predictor m_predictor;
    std::unique_ptr<Bounded> m_bounded;
    std::unique_ptr<PngRows> m_rows;
    std::unique_ptr<Pl_Flate> m_flate;
};

/// Filter that leaves its stream packed.
class Refused : public QPDFStreamFilter {
public:
    bool setDecodeParms(QPDFObjectHandle) override { return false; }
    Pipeline *getDecodePipeline(Pipeline *next) override { return next; }
};

void registerFilters() {
    QPDF::registerStreamFilter("/FlateDecode", [] { return std::make_shared<BoundedFlate>(); });
    for (const char *name :
         {"/LZWDecode", "/RunLengthDecode", "/ASCII85Decode", "/ASCIIHexDecode", "/DCTDecode", "/Crypt"})
        QPDF::registerStreamFilter(name, [] { return std::make_shared<Refused>(); });
}

} // namespace

UnpackingBound::UnpackingBound(std::int64_t most) {
    static std::once_flag once;
    std::call_once(once, registerFilters);
    room = most;
}

UnpackingBound::~UnpackingBound() {
    room = unbounded;
}

bool UnpackingBound::isExceeded() {
    return room < 0;
}

} // namespace palmer
