#pragma once

#include "ui/editor/EditorContext.h"
#include "ui/widgets/ChartScene.h"

/// The draft on the chart: what is drawn of it, what can be dragged, and what a drag makes of it.
namespace sagara::ui::editor {

struct DraftHandle {
    enum class Kind {
        Point,         ///< `path` is a position
        Ship,          ///< `path` is an own ship at sea
        Heading,       ///< `path` is an own ship at sea
        ShipAtBerth,   ///< `path` is an own ship alongside: she goes along the berth, or to a nearer one
        Place,         ///< `path` is a place: a position, or the name of one of the area
        RadiusMiles,   ///< `path` is a number
        RadiusMetres,  ///< `path` is a number
    };
    Kind kind = Kind::Point;
    std::string path;
    core::NorthEast position;
    core::NorthEast centre;  ///< of a radius or heading
    QString hint;
    bool open = false;  ///< see ChartHandle
};

struct DraftPicture {
    ChartScene scene;  ///< with the handles, their ids the index in `handles`
    std::vector<DraftHandle> handles;
};

/// `section`: the page that is open; its things have handles, those of the chosen row where they are many.
/// Nothing before the area is read.
DraftPicture pictureOf(const EditorContext& context, const std::string& section);

/// What comes as near as `snap_m` to a named place of the area takes its name.
void drag(Json& document, const core::Area& area, const DraftHandle& handle, core::NorthEast to,
          double snap_m);

}  // namespace sagara::ui::editor
