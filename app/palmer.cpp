#include "ui/fonts.h"
#include "ui/theme.h"
#include "ui/typingguard.h"
#include "ui/wheelguard.h"
#include "ui/window/mainwindow.h"
#include "ui/windowlanguage.h"

#include <QApplication>
#include <QHashSeed>
#include <QIcon>

int main(int argc, char *argv[]) {
    using namespace palmer::ui;
    QHashSeed::setDeterministicGlobalSeed(); // before all else: the same report is the same bytes
    QApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("palmer"));
    QCoreApplication::setOrganizationName(QStringLiteral("palmer"));
    QCoreApplication::setApplicationVersion(QStringLiteral(PALMER_VERSION));
    QGuiApplication::setApplicationDisplayName(QStringLiteral("Palmer"));
    QGuiApplication::setDesktopFileName(QStringLiteral("palmer"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/palmer.svg")));
    QApplication::setStyle(QStringLiteral("fusion"));
    loadFonts();
    restoreWindowLanguage();
    installTheme();
    guardWheel(application);
    guardTyping(application);

    auto *window = new MainWindow; // deletes itself when it is closed
    window->show();
    const QStringList files = QCoreApplication::arguments().mid(1);
    for (const QString &file : files)
        window->openFile(file);
    window->offerRecoveries();
    return QApplication::exec();
}
