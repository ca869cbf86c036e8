#pragma once

#include <functional>
#include <vector>

#include "ui/theme/Page.h"

class QLabel;
class QVBoxLayout;

namespace sagara::ui {

/// One thing to do behind a door.
struct Room {
    QString name;
    QString tip;
    QString objectName;
    std::function<void()> enter;
};

/// One kind of user's way in.
struct Door {
    QString name;
    QString icon;             ///< of assets/icons
    QString text;             ///< for whom, and what for
    std::vector<Room> rooms;  ///< the first is entered by a click on the picture
};

/// The doors of the station: what each user can do here, and what is to be decided first.
class HomePage final : public Page {
    Q_OBJECT

public:
    explicit HomePage(std::vector<Door> doors, QWidget* parent = nullptr);

    void setColours(PaletteName name) override;
    QString helpTopic() const override { return QStringLiteral("start"); }

    /// Something the person must know, or decide: with a button for each way. Goes when a button is used.
    void addNotice(const QString& text, std::vector<Room> ways = {});

private:
    QWidget* card(const Door& door);

    std::vector<Door> m_doors;
    std::vector<QLabel*> m_pictures;
    QVBoxLayout* m_notices;
};

}  // namespace sagara::ui
