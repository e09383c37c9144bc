// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "figures/figure.h"
#include "import/importmeasurement.h"
#include "import/profiles.h"
#include "ui/import/rawtextmodel.h"
#include "ui/import/recognisedmodel.h"
#include "ui/model/background.h"
#include "ui/model/selection.h"

#include <QDialog>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QListView;
class QPushButton;
class QScrollArea;
class QStackedWidget;
class QTableView;

namespace palmer::ui {

class CircleCanvas;
class ColumnRoles;
class FigureCanvas;
class LineView;
class RemarkList;
class WorkBar;
class ZoomButtons;

/// A measurement file as it was read; may be made on any thread.
struct MeasurementFile {
    QByteArray bytes;
    QString name; ///< without its folder
    Imported imported;
    std::string hash; ///< SHA-256 of the bytes
    TestPointer test; ///< that of `imported`, for who draws it on another thread; null for none
    TextLines lines;  ///< of `imported`
};

/// Throws Error for bytes of which nothing can be shown.
[[nodiscard]] MeasurementFile readMeasurementFile(const QByteArray &bytes, const QString &fileName,
                                                  const ImportOptions &options = {});

/// Whether reading takes longer than a window may stand still: then it is read on a thread.
[[nodiscard]] bool isLargeFile(qint64 bytes);

/// "Import…": what a measurement file says, before anything is accepted. The text as it was read, the roles
/// of its columns, the table and the curve that come of it, every choice with how it came about, the
/// questions and the remarks. Another choice reads the file anew; nothing comes in before each question is
/// answered. A file of which no measurement can be read is shown with what is missing. Changes no document:
/// whoever opened it puts in what was read, with addTo().
class ImportAssistant : public QDialog {
    Q_OBJECT

public:
    /// `open`: the document that is open, to put the measurement into; null for none. Throws Error for bytes
    /// of which nothing can be shown.
    ImportAssistant(const QByteArray &bytes, const QString &fileName, const Document *open,
                    QWidget *parent = nullptr);
    ImportAssistant(MeasurementFile file, const Document *open, QWidget *parent = nullptr);

    [[nodiscard]] const Imported &imported() const { return m_file.imported; }
    /// Whether the measurement shall be a new document and not go into the open one.
    [[nodiscard]] bool wantsNewDocument() const;
    /// At once for the document that it was accepted for: all was done before.
    void addTo(Document &document) const;

    /// Chooses a word, number or text for a choice, as its box does; empty: what is found in the file.
    void choose(const std::string &key, const std::string &value);
    /// Takes what is proposed to every question but those about data that were not read.
    void confirmAll();
    /// Reads other bytes in the place of those at hand; what cannot be read is said, and nothing changes.
    /// Large files are read beside the window, with a bar and Cancel, which leaves all as it was.
    void takeFile(const QByteArray &bytes, const QString &fileName);
    void pasteText();

    /// Says how many files are asked about after this one.
    void setFollowing(qsizetype files);

    /// Keeps what was chosen under a name: neither what the file itself says nor a guess that nobody has
    /// confirmed. False, and a message, when that fails.
    bool saveProfile(const QString &name);

    /// Puts a large measurement into the document beside the window, and closes when that is done.
    void accept() override;

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    struct Box {
        std::string key;
        QWidget *cell = nullptr;
        QLabel *name = nullptr;
        QLabel *badge = nullptr;
        QComboBox *words = nullptr; ///< null: typed
        QLineEdit *edit = nullptr;
    };

    void makeLayout();
    QWidget *makeMiddle();
    QWidget *makeRemarks();
    void connectAll();
    /// Size and hash of the file, and how many follow it.
    void sayOrigin();
    void useLastProfile();
    void chooseOther();
    void takeTyped();
    void takeOptions(ImportOptions options);
    void read(const QByteArray &bytes, const QString &name, const ImportOptions &options,
              std::function<void(std::variant<MeasurementFile, Error>)> take);
    void settle();
    void cancelReading();
    void takeOther(MeasurementFile file);
    [[nodiscard]] Document destination() const;
    [[nodiscard]] std::function<std::variant<Document, Error>(Document)> taking() const;
    void finish(std::variant<Document, Error> outcome);
    void showEvaluated(const EvaluatedDocument &evaluated, std::optional<CurveFigure> curve);
    void useProfile(const QString &name);
    void fillProfiles(const QString &current);
    void askProfileName();
    void readTableAt(const QModelIndex &place);
    [[nodiscard]] std::vector<ImportChoice> shownChoices() const;
    void makeBoxes();
    void changeBoxes(const std::vector<ImportChoice> &shown);
    [[nodiscard]] Box makeBox(const ImportChoice &choice);
    void fillEditions(QComboBox &editions) const;
    [[nodiscard]] int boxColumns() const;
    void placeBoxes();
    void showChoices();
    /// The value of a choice in its box.
    void showChoice(const Box &box, const QString &value, bool guessed);
    void fillSheets(QComboBox &sheets) const;
    void showLine(std::size_t line);
    void showAnswerOf(const QString &key);
    void showRemarks();
    void showCurve();
    void showSizes();
    // What the measurement of a kind counts.
    [[nodiscard]] static QStringList sizesOf(const PositioningMeasurement &measurement);
    [[nodiscard]] QStringList sizesOf(const CircularMeasurement &measurement) const;
    [[nodiscard]] QStringList sizesOf(const DriftMeasurement &measurement) const;
    [[nodiscard]] QString pointsText() const;
    void showState();
    void refresh();
    void takeRead(MeasurementFile file);
    void refuse(const Error &error, const QString &file);
    void retranslate();

    MeasurementFile m_file;
    std::optional<Document> m_document; ///< the open one
    ImportOptions m_options;
    ImportOptions m_settled; ///< those that what is shown was read with
    QString m_settledProfile;
    std::optional<Document> m_taken; ///< the document with the measurement, when it was accepted
    int m_following = 0;             ///< files that come after this one
    ImportProfiles m_profiles;
    std::optional<QString> m_refusal; ///< why the latest choices cannot be used
    Selection m_selection;
    RawTextModel m_raw;
    RecognisedModel m_recognised;
    std::optional<CurveFigure> m_curve; ///< of a large measurement as much as a screen resolves
    std::vector<Box> m_boxes;

    QLabel *m_title;
    QLabel *m_origin;
    QPushButton *m_other;
    QPushButton *m_paste;
    QGridLayout *m_choices;
    int m_boxColumns = 0;
    QLabel *m_destinationName;
    QComboBox *m_destination;
    QLabel *m_profileName;
    QComboBox *m_profile;
    QLabel *m_rawTitle;
    QLabel *m_rawSize;
    QListView *m_rawView;
    QLabel *m_tableTitle;
    QLabel *m_tableSize;
    ColumnRoles *m_columns;
    QTableView *m_table;
    QLabel *m_curveTitle;
    ZoomButtons *m_zoom;
    QStackedWidget *m_curves;
    FigureCanvas *m_curveCanvas;
    CircleCanvas *m_circleCanvas;
    LineView *m_lineView;
    QLabel *m_noCurve;
    QLabel *m_remarksTitle;
    QPushButton *m_confirmAll;
    RemarkList *m_remarks;
    QScrollArea *m_remarksPlace = nullptr;
    QCheckBox *m_keep;
    QPushButton *m_saveProfile;
    QLabel *m_open;
    QPushButton *m_cancel;
    QPushButton *m_import;
    WorkBar *m_work;
    Background m_reader;
    Background m_drawer; ///< of the curve of a large measurement
};

} // namespace palmer::ui
