// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/agreedvalue.h"

#include "document/edits.h"
#include "kernel/evaluation/agreedpoints.h"
#include "kernel/measurement/testfacts.h"

namespace palmer::ui {

Member<std::optional<double>> agreedValue(const char *point) {
    return {[point](const FormSource &source) {
                const AgreedPoint *agreed = source.test ? agreedPoint(*source.test, point) : nullptr;
                return agreed ? agreed->value : std::nullopt;
            },
            [point](Document &document, std::size_t index, const std::optional<double> &value) {
                editTest(document, index, [&](Test &test) {
                    const AgreedPoint *before = agreedPoint(test, point);
                    if (value || before)
                        setAgreedPoint(test, point, value ? AgreementState::agreed : before->state,
                                       before ? before->text : std::string());
                    for (AgreedPoint &agreed : test.agreedPoints) {
                        if (agreed.point == point)
                            agreed.value = value;
                    }
                });
            }};
}

std::optional<Quantity> agreedQuantity(std::string_view point, const Test &test) {
    if (!isJudged(test) || !axisOf(test))
        return std::nullopt;
    if (point == "gradient")
        return Quantity::gradient;
    if (point == "feed")
        return feedQuantity(test);
    return std::nullopt;
}

} // namespace palmer::ui
