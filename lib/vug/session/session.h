// SPDX-License-Identifier: Apache-2.0
// Umbrella header of the public interface: loading a scene, building it, rendering pictures,
// delivering files.
#pragma once

#include <vug/building/builder.h>
#include <vug/delivery/describe_file.h>
#include <vug/delivery/export_set.h>
#include <vug/delivery/measure.h>
#include <vug/delivery/recipe.h>
#include <vug/delivery/write_products.h>
#include <vug/loading/catalogue.h>
#include <vug/loading/data_folders.h>
#include <vug/loading/dependencies.h>
#include <vug/loading/load.h>
#include <vug/loading/plugin.h>
#include <vug/picture/frame_sequence.h>
#include <vug/picture/picture_file.h>
#include <vug/picture/render_job.h>
#include <vug/picture/stereo_views.h>
#include <vug/session/archetypes.h>
#include <vug/session/facade_fit.h>
#include <vug/session/facade_model.h>
#include <vug/session/facade_picture.h>
#include <vug/session/preview.h>
#include <vug/shot/queries.h>
#include <vug/shot/shot.h>
