#pragma once

#include "ui/settings/Section.h"

namespace sagara::ui {

/// Where this installation keeps its things. For reading only: the folder is chosen when Sagara is started.
struct DataPlaces {
    QString folder;
    QString database;         ///< file
    QString databaseTrouble;  ///< empty when it can be used
    QString recordings;
};

class DataSection final : public Section {
    Q_OBJECT

public:
    DataSection(const DataPlaces& places, QWidget* parent);
};

}  // namespace sagara::ui
