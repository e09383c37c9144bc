// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/choices.h"
#include "import/remark.h"

#include <QByteArrayView>
#include <QSet>
#include <QString>
#include <QXmlStreamReader>
#include <array>

namespace palmer {

/// Units of the attribute DT.
struct TypeUnit {
    const char *type = nullptr;
    const char *unit = nullptr; ///< for display
    double multiplier = 1;      ///< for lengths: to mm
    double divisor = 1;
    bool isLength = false; ///< false: for display only
};
/// Null for an unknown one.
[[nodiscard]] const TypeUnit *typeUnit(QStringView type);

/// The encoding that the XML declaration names; empty: none, or not in ASCII.
[[nodiscard]] QString declaredEncoding(QByteArrayView bytes);
/// Notes an encoding other than UTF-8.
void remarkEncoding(QByteArrayView bytes, Remarks &remarks);

/// The elements and attributes of a ballbar file that have no field: they are listed, but for the angles of
/// the path, which the description of the format lacks.
class BallbarElements {
public:
    [[nodiscard]] static bool isKnown(const QString &name);
    [[nodiscard]] static bool isAngle(const QString &name);
    void addAttributes(const QString &element, const QXmlStreamAttributes &attributes);
    /// `type`: the attribute DT.
    void add(const QString &name, const QString &value, const QString &type);
    /// Settles an angle of the path: what an element states, to be confirmed, or `usual`, with a text unless
    /// that is no question.
    Choice<double> resolveAngle(std::string_view key, double usual, Text assumed, Choices &choices,
                                Remarks &remarks) const;
    void remark(Remarks &remarks) const;

private:
    struct StatedAngle {
        QString text = {}; ///< as the file says; empty: not stated
        double value = 0;
    };
    std::array<StatedAngle, 3> m_angles;
    QSet<QString> m_unread;
};

} // namespace palmer
