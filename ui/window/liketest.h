// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

namespace palmer::ui {

/// A test of the same machine whose statements can be taken.
struct LikeTest {
    std::shared_ptr<const Document> document;
    std::size_t test = 0;
    QString file; ///< path; empty: the open file
};

/// Returns the newest other test that test `index` can be filled like, rather one of its axis: of the
/// document, or of the same machine in the register at that address; `machine` (as listed) where the document
/// names none. Null if there is none. `path`: of the document, which is not looked for in the register.
/// Throws Error if the file is not read.
[[nodiscard]] std::optional<LikeTest> lastTestOfMachine(const std::shared_ptr<const Document> &document,
                                                        std::size_t index, const QString &path,
                                                        const QString &address, const QString &machine = {});

/// Names of the machines of the register, as lastTestOfMachine() takes them.
[[nodiscard]] QStringList machinesOfRegister(const QString &address);

} // namespace palmer::ui
