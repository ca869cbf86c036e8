#pragma once

#include <QLabel>

namespace sagara::ui::roster {

/// Below a field: what is wrong with its entry and what is accepted; takes room only when it says something.
class FieldNote final : public QLabel {
    Q_OBJECT

public:
    explicit FieldNote(QWidget* parent = nullptr);
    void say(const QString& fault);
    bool ok() const { return text().isEmpty(); }

protected:
    void paintEvent(QPaintEvent* event) override;
};

QLabel* heading(const QString& text, double scale, QWidget* parent);
/// Quiet words that explain, broken over lines.
QLabel* hint(const QString& text, QWidget* parent);

}  // namespace sagara::ui::roster
