// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Links every object of palmer_core with Qt Core alone: a widget in core would not link.
#include <QtGlobal>

int main() {
    return qVersion() != nullptr ? 0 : 1;
}
