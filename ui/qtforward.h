// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Classes of Qt that headers of ui name; their sources include them.
class QAction;
class QApplication;
class QButtonGroup;
class QCategoryAxis;
class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFontMetrics;
class QFormLayout;
class QFrame;
class QGridLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QLineSeries;
class QListView;
class QListWidget;
class QMainWindow;
class QMenu;
class QMenuBar;
class QMimeData;
class QPlainTextEdit;
class QPrinter;
class QProgressBar;
class QPushButton;
class QScatterSeries;
class QScrollArea;
class QSplitter;
class QStackedWidget;
class QTabWidget;
class QTableView;
class QTableWidget;
class QTextBrowser;
class QTimer;
class QToolBar;
class QToolButton;
class QTreeWidget;
class QVBoxLayout;
class QWidget;
