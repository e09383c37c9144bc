// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/process.h"

#include <QCoreApplication>
#include <QLocale>
#include <QObject>
#include <QSettings>
#include <memory>
#include <windows.h>

// Before all others: MinGW clears thread_local memory before the destructors that use it, unless the program
// has registered one itself.
extern "C" int __cxa_thread_atexit(void (*destructor)(void *), void *object, void *library);

namespace {

constexpr int first = 101;

[[gnu::constructor(first)]] void registerThreadEnd() {
    __cxa_thread_atexit([](void *) {}, nullptr, nullptr);
}

} // namespace

namespace palmer {

QStringList wordsOf(int argc, const char *const *) {
    int count = 0;
    const std::unique_ptr<LPWSTR, decltype(&::LocalFree)> all(
        ::CommandLineToArgvW(::GetCommandLineW(), &count), &::LocalFree);
    if (argc < count) // Qt has taken its options
        return QCoreApplication::arguments().mid(1);
    QStringList words;
    for (int i = 1; i < count; ++i)
        words << QString::fromWCharArray(all.get()[i]);
    return words;
}

QString localeOfSystem() {
    return QLocale::system().uiLanguages().value(0);
}

void reportFilesTooLarge() {}
void reportBrokenPipes() {}

bool hasScreen() {
    return true;
}

void onEnd(QObject &, std::function<void()>) {
} // Windows asks each window (QGuiApplication::commitDataRequest)

QString processorName() {
    const QSettings processor(
        QStringLiteral("HKEY_LOCAL_MACHINE\\HARDWARE\\DESCRIPTION\\System\\CentralProcessor\\0"),
        QSettings::NativeFormat);
    return processor.value(QStringLiteral("ProcessorNameString")).toString().trimmed();
}

} // namespace palmer
