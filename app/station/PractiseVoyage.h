#pragma once

#include <QObject>
#include <QPointer>

#include "app/station/PractiseDoor.h"
#include "app/station/StationRun.h"
#include "ui/practise/PractisePorts.h"
#include "ui/practise/SailResult.h"

class QTimer;

namespace sagara::station {

/// The runs of somebody who sails alone: opened with their console, ended when it is left or the exercise is
/// over, then shown with their result. Belongs to the practise page.
class PractiseVoyage final : public QObject {
    Q_OBJECT

public:
    PractiseVoyage(Frame& frame, PractiseWays ways, QObject* parent);

    /// The error is for the person who chose.
    std::optional<std::string> sail(std::shared_ptr<const core::World> world,
                                    const ui::PractiseChoice& choice);
    std::optional<std::string> replay(const std::filesystem::path& recording, double time_s);
    StationRun* run() const { return m_run.get(); }

private:
    std::optional<std::string> begin(bool inPlaceOfResult);
    void finish();
    ui::SailResult resultOf(const run::RunSummary& summary) const;

    Frame& m_frame;
    PractiseWays m_ways;
    std::shared_ptr<const core::World> m_world;
    ui::PractiseChoice m_choice;
    std::shared_ptr<StationRun> m_run;  ///< the console keeps it too: it may go after this
    QPointer<ui::Page> m_console;
    QTimer* m_watch;
};

/// What that person has sailed, newest first; the result of the best run of a scenario in words.
std::vector<ui::PastRun> pastRuns(run::Store& store, const std::string& person);

}  // namespace sagara::station
