// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/queries.h"

#include <QCoreApplication>
#include <array>

namespace palmer::ui {

/// The values by which the tests of a machine are filtered.
struct TestFilters {
    Q_DECLARE_TR_FUNCTIONS(palmer::ui::TestFilters)

public:
    enum Property { axis, since, edition, purpose, role, limits, accordance, count };

    /// Value of a property; an empty one cannot be chosen.
    [[nodiscard]] static QString valueOf(Property property, const ListedTest &listed);
    [[nodiscard]] static QString nameOf(Property property, const QString &value);

    [[nodiscard]] bool passes(Property property, const ListedTest &test) const;
    [[nodiscard]] bool passes(const ListedTest &test) const; ///< all of them

    std::array<QString, count> chosen; ///< empty: all
};

} // namespace palmer::ui
