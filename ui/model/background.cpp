// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/background.h"

namespace palmer::ui {

void Background::Job::post(std::function<void()> onResult) const {
    QMetaObject::invokeMethod(
        &m_place,
        [stop = m_stop, onResult = std::move(onResult)] {
            if (!stop.stop_requested())
                onResult();
        },
        Qt::QueuedConnection);
}

Background::Background() {
    m_thread.setMaxThreadCount(1);
}

Background::~Background() {
    cancel();
    wait();
}

void Background::cancel() {
    m_stop.request_stop();
    m_stop = {};
    m_open = 0;
}

} // namespace palmer::ui
