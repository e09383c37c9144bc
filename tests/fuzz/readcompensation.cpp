#include "document/documenterror.h"
#include "export/compensation.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

/// Compensation tables of any kind: an Error, or a table of numbers that ascends.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    try {
        const palmer::CompensationTable table = palmer::readCompensation(
            QByteArrayView(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size)));
        if (table.positions.size() != table.forward.size() || table.positions.size() != table.reverse.size())
            std::abort();
        (void)table.correction(table.positions.front(), palmer::Direction::negative);
    } catch (const palmer::Error &) {
    }
    return 0;
}
