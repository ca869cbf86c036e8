#pragma once

#include <QDialog>
#include <QString>
#include <QVector>

namespace sagara::ui {

/// What the About dialog says. Whoever knows the installation fills it in.
struct AboutFacts {
    QString version;
    QString buildId;
    QString attributions;  ///< assets/ATTRIBUTION.md
    /// What a document asks to be shown wherever it is used.
    struct Credit {
        QString document;  ///< "Area: Galle, Sri Lanka"
        QStringList lines;
    };
    QVector<Credit> credits;
};

/// Version, licence, build and everybody who must be named.
class AboutDialog final : public QDialog {
    Q_OBJECT

public:
    explicit AboutDialog(const AboutFacts& facts, QWidget* parent = nullptr);
};

/// The credits of a document's text: its "attribution", a text or a list of texts. Empty without one.
QStringList attributionOf(const std::string& documentText);

void showAbout(QWidget* parent, const AboutFacts& facts);

}  // namespace sagara::ui
