#pragma once

#include "app/station/Frame.h"

/// The admin's pages over the store.
namespace sagara::station {

ui::Page* vesselsPage(Frame& frame);
ui::Page* databasePage(Frame& frame);

}  // namespace sagara::station
