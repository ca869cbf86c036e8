#pragma once

#include <QString>
#include <string>
#include <vector>

namespace sagara::ui {

/// A run sailed alone, as its result page shows it.
struct SailResult {
    struct Task {
        QString title;
        bool done = false;
        double time_s = 0.0;
    };
    struct Loss {
        double time_s = 0.0;
        QString title;
        QString detail;  ///< "speed over ground 7.4 kn, limit 6 kn"
        double points = 0.0;
        bool fails = false;
    };
    QString name;
    bool graded = false;  ///< there was something to grade
    bool passed = false;
    double score = 100.0;
    QString whyNot;
    double sailed_s = 0.0;
    std::vector<Task> tasks;
    std::vector<Loss> losses;
    std::string recording;
    QString trouble;  ///< of filing it
    QString best;     ///< "Your best here: 92, 3 March 2027"; empty without a name
};

}  // namespace sagara::ui
