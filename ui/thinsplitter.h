// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSplitter>

namespace palmer::ui {

/// A splitter whose handle is a line 1 px wide with a grab area of 8 px.
class ThinSplitter : public QSplitter {
    Q_OBJECT

public:
    explicit ThinSplitter(Qt::Orientation orientation, QWidget *parent = nullptr);

protected:
    QSplitterHandle *createHandle() override;
};

} // namespace palmer::ui
