#pragma once

#include <QLabel>
#include <QPointer>
#include <QWidget>

#include "ui/theme/PaletteName.h"

namespace sagara::ui {

/// One subject of the settings page.
class Section : public QWidget {
    Q_OBJECT

public:
    Section(const QString& title, const QString& icon, QWidget* parent);
    const QString& title() const { return m_title; }
    const QString& icon() const { return m_icon; }  ///< name for themedIcon
    virtual void setColours(PaletteName palette);
    /// Shows what is live; called some 30 times a second while the section is seen.
    virtual void refresh() {}

protected:
    PaletteName palette() const { return m_paletteName; }
    /// A line that explains; wraps.
    QLabel* note(const QString& text);
    /// A line in the colour of alarms, hidden while there is nothing to say: see say().
    QLabel* complaint(const char* name);
    static void say(QLabel* complaint, const QString& text);

private:
    QString m_title;
    QString m_icon;
    PaletteName m_paletteName = PaletteName::Day;
    QList<QPointer<QLabel>> m_complaints;  ///< some live shorter than the section
    QList<QPointer<QLabel>> m_notes;
};

}  // namespace sagara::ui
