#pragma once

#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <vector>

#include "app/station/Station.h"

namespace sagara::tour {

/// The station as somebody sees it who walks through it: finds what the person would use by its object name,
/// uses it, and keeps pictures of every screen in each size and palette asked for. What is not there or does
/// not happen in time is noted; the walk goes on.
class Screens {
public:
    struct Look {
        std::vector<QSize> sizes{{1280, 720}};
        std::vector<ui::PaletteName> palettes{ui::PaletteName::Day};
        std::filesystem::path folder;  ///< of the pictures; empty: none
    };
    Screens(station::Station& station, Look look) : m_station(station), m_look(std::move(look)) {}

    /// Pictures of what is shown now: NAME-1280x720-day.png and so on.
    void keep(const QString& name);
    /// The same of another window of the program.
    void keepWindow(QWidget* window, const QString& name);

    /// Null, and noted, when there is none that can be seen.
    QWidget* find(const QString& objectName);
    template <typename Widget>
    Widget* find(const QString& objectName) {
        auto* const found = dynamic_cast<Widget*>(find(objectName));
        if (found == nullptr) fail(objectName + QStringLiteral(" is not what it should be"));
        return found;
    }
    void click(const QString& objectName);
    void type(const QString& objectName, const QString& text);
    /// Yes to the question that is about to be asked, if one is.
    void sayYes();
    /// By its text or its data.
    void choose(const QString& comboBox, const QString& entry);
    bool waitFor(const QString& what, const std::function<bool()>& done, int atMost_ms = 30'000);
    void expect(bool holds, const QString& what) {
        if (!holds) fail(what);
    }
    void fail(const QString& what);

    const QStringList& failures() const { return m_failures; }
    station::Station& station() { return m_station; }
    int pictures() const { return m_pictures; }

private:
    void settle();

    station::Station& m_station;
    Look m_look;
    QStringList m_failures;
    int m_pictures = 0;
};

}  // namespace sagara::tour
