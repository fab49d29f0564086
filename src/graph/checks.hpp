#pragma once

#include "graph/graph.hpp"

namespace velarium::graph {

// What declarations refuse, by an Error(internal) that names the pass and the resource.

// The handle names what was overwritten since; or, where the use needs contents, what nobody wrote.
void refuse_stale(const Pass& pass, GraphImage handle, const Graph::ImageResource& image, bool needs_contents);
void refuse_stale(const Pass& pass, GraphBuffer handle, const Graph::BufferResource& buffer, bool needs_contents);

// The access is no way to use what the handle names.
void refuse_misfit(const Pass& pass, GraphImage handle, const Graph::ImageResource& image, const AccessInfo& access);

// A write by an access that only reads.
void refuse_read_only(const Pass& pass, const AccessInfo& access, const std::string& resource);

// A second resource of this full name.
void refuse_same_name(const Pass& pass, bool taken, const std::string& name);

}  // namespace velarium::graph
