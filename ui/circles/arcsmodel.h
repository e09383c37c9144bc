// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "ui/quiettable.h"

#include <QStringList>
#include <vector>

namespace palmer::ui {

struct ArcRow {
    Sense sense = Sense::counterclockwise;
    QStringList texts; ///< by column
};

/// The arcs of a circular test in measured order: points, start, end, the part left out, least squares
/// radius.
class ArcsModel : public RowModel<ArcRow> {
    Q_OBJECT

public:
    enum Column { sense, points, from, to, cut, radius, use, columns };

    explicit ArcsModel(QObject *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test, const Language &language);

protected:
    [[nodiscard]] QVariant cell(const ArcRow &row, int column, int role) const override;

private:
    void makeColumns(const QString &unit);
};

} // namespace palmer::ui
