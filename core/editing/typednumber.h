#pragma once

#include "kernel/words/message.h"

#include <QStringView>
#include <optional>
#include <string>

namespace palmer {

/// What a typed text says: a decimal number ("-4.8": point, hyphen, no grouping), nothing at all, or why it
/// is no number.
struct TypedNumber {
    std::string decimal; ///< empty: no number
    Text problem;        ///< empty: none

    [[nodiscard]] bool isEmpty() const { return decimal.empty() && problem.empty(); }
};

/// Reads a number as it is typed into a field. Comma and point are both the decimal mark, for hands follow
/// the keyboard and not the language; therefore a group separator is none but the narrow space that the
/// window writes itself, and a second mark is refused: "1,234.5" never becomes another number. Minus as −, –
/// or -. A dash alone says, as it does where it is shown, that there is nothing.
[[nodiscard]] TypedNumber typedNumber(QStringView text);

} // namespace palmer
