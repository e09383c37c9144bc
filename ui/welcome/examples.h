// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace palmer::ui {

/// A built-in example.
struct Example {
    QString path; ///< in the resources
    QString name; ///< in the window's language
    QString year; ///< of the edition
    bool circular = false;
    bool teaching = false; ///< a circle with one influence, which the diagnosis finds
};

/// The examples, the published one first.
[[nodiscard]] std::vector<Example> examples();

/// The example of a type test: a folder with the tests of several machines. Year of the edition as above.
[[nodiscard]] Example typeExample();

/// Edition and size of an example, in the window's language; reads the file.
[[nodiscard]] QString exampleDetail(const QString &path);

/// True if the path is that of an example, which is opened as a document without file.
[[nodiscard]] bool isExample(const QString &path);

} // namespace palmer::ui
