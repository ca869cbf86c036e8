#pragma once

#include <QDialog>
#include <array>
#include <functional>
#include <optional>
#include <string>

#include "core/vessel/Vessel.h"
#include "ui/theme/PaletteName.h"
#include "ui/vessels/ShipView.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTimer;

namespace sagara::ui {

/// Gives a vessel a 3D model file: which way it looks, how large it is, where it floats and where its lights
/// are, seen in a view as they are set.
class ModelDialog final : public QDialog {
    Q_OBJECT

public:
    using Save = std::function<std::optional<std::string>(const std::string& text)>;

    /// `text` is the vessel's document. Files are copied below `ownModels` when they are chosen.
    ModelDialog(const std::string& text, std::filesystem::path ownModels, PaletteName colours,
                StageFor stageFor, Save save, QWidget* parent = nullptr);

    /// Takes a model file, as if it had been chosen. What is wrong with it, or nothing.
    std::optional<std::string> takeFile(const std::filesystem::path& file);
    /// The document with the picture as it is set; without one when there is no model.
    std::string text() const;
    void accept() override;

private:
    struct LightRow {
        QCheckBox* on;
        QDoubleSpinBox *forward, *starboard, *height;
    };
    QDoubleSpinBox* metres(double low, double high, const QString& tip);
    QWidget* lightTable();
    void readPicture();
    void change();
    void preview();

    std::string m_text;
    std::filesystem::path m_ownModels;
    Save m_save;
    ShipView* m_view;
    QLabel *m_file, *m_note;
    QComboBox *m_forward, *m_up, *m_fit;
    QDoubleSpinBox *m_scale, *m_waterline, *m_midship;
    QCheckBox *m_middle, *m_night;
    QLineEdit *m_licence, *m_source;
    std::array<LightRow, core::kLightPlaces> m_lights;
    QPushButton* m_ok;
    QTimer* m_timer;
    std::string m_model;
};

}  // namespace sagara::ui
