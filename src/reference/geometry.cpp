#include "reference/geometry.hpp"

#include "core/assert.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstring>
#include <map>

namespace velarium::reference {
namespace {

// Copies of a mesh with fewer triangles in all are worth their memory: a hierarchy without instances is faster.
constexpr std::uint64_t kCopiedTriangles = 1u << 16;

RTCRay embree_ray(const Ray& ray) {
  RTCRay r{};
  r.org_x = ray.origin.x;
  r.org_y = ray.origin.y;
  r.org_z = ray.origin.z;
  r.tnear = ray.from;
  r.dir_x = ray.direction.x;
  r.dir_y = ray.direction.y;
  r.dir_z = ray.direction.z;
  r.tfar = ray.to;
  r.mask = ~0u;
  return r;
}

template <class Position>
void fill_triangles(RTCGeometry geometry, const Object& object, Position position) {
  const std::size_t vertices = object.vertices->positions.size(), triangles = object.triangle_count();
  auto* p = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices));
  auto* i = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                3 * sizeof(std::uint32_t), triangles));
  if (p == nullptr || i == nullptr) throw Error(ErrorCode::temporary, "not enough memory for the scene's triangles");
  for (std::size_t v = 0; v < vertices; ++v, p += 3) {
    const glm::vec3 at = position(static_cast<std::uint32_t>(v));
    std::memcpy(p, &at, 3 * sizeof(float));
  }
  std::memcpy(i, object.primitive->indices.data(), 3 * triangles * sizeof(std::uint32_t));
}

// Looks random in each.
std::uint32_t fate_of(std::uint32_t ray, std::uint32_t object, std::uint32_t triangle) {
  return shading::hash_u32(ray ^ shading::hash_u32(triangle ^ shading::hash_u32(object)));
}

}  // namespace

// Geometry ids are object numbers. In the scene of a shared mesh the one geometry is 0, and the instance has the
// number.
struct Geometry::Context {
  RTCIntersectContext embree;  // first: filters find the rest behind it
  const Geometry* geometry;
  const Ray* ray;
  TransparentHits transparent;

  Context(const Geometry* g, const Ray* r) : embree{}, geometry(g), ray(r) {
    rtcInitIntersectContext(&embree);
    if (r->skip_back_faces) embree.filter = filter_back_faces;
  }
  static Context& of(const RTCFilterFunctionNArguments* arguments) {
    return *reinterpret_cast<Context*>(arguments->context);
  }
};

Geometry::Geometry(const std::vector<Object>& objects, const Materials& materials)
    : objects_(objects), materials_(materials) {
  // One thread builds, so that triangles that lie on each other are always met in the same order.
  device_.reset(rtcNewDevice("threads=1"));
  if (!device_) throw Error(ErrorCode::temporary, "Embree gives no device; is there memory?");
  std::map<std::uint32_t, std::vector<std::uint32_t>> users;  // of each mesh
  for (std::uint32_t i = 0; i < objects_.size(); ++i) users[objects_[i].mesh].push_back(i);
  top_ = new_scene();
  for (const auto& [mesh, numbers] : users) {
    const Object& first = objects_[numbers.front()];
    const std::uint64_t triangles = std::uint64_t{first.triangle_count()} * numbers.size();
    if (numbers.size() == 1 || triangles <= kCopiedTriangles) {
      for (const std::uint32_t number : numbers) add_flat(top_.get(), number, number);
      continue;
    }
    SceneOwner& shared = meshes_.emplace_back(new_scene());
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    fill_triangles(geometry, first, [&](std::uint32_t v) { return first.vertices->positions[v]; });
    attach(shared.get(), geometry, first.material, 0);
    rtcCommitScene(shared.get());
    for (const std::uint32_t number : numbers) add_instance(shared.get(), number, number);
  }
  rtcCommitScene(top_.get());
  check("building the hierarchy of triangles");
}

Geometry::SceneOwner Geometry::new_scene() const {
  SceneOwner scene(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene.get(),
                   static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
  return scene;
}

void Geometry::add_flat(RTCScene scene, std::uint32_t object, unsigned id) {
  const Object& o = objects_[object];
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  fill_triangles(geometry, o, [&](std::uint32_t v) { return o.position_ws(v); });
  attach(scene, geometry, o.material, id);
}

void Geometry::add_instance(RTCScene mesh, std::uint32_t object, unsigned id) {
  const Object& o = objects_[object];
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, mesh);
  std::array<float, 12> columns{};
  for (int c = 0; c < 4; ++c) {
    const glm::vec3 column = c < 3 ? o.turn[c] : o.place;
    std::memcpy(&columns[3 * static_cast<std::size_t>(c)], &column, 3 * sizeof(float));
  }
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(top_.get(), geometry, id);
  rtcReleaseGeometry(geometry);
}

void Geometry::attach(RTCScene scene, RTCGeometry geometry, std::uint32_t material, unsigned id) {
  if (materials_.may_be_transparent(material)) {
    rtcSetGeometryIntersectFilterFunction(geometry, filter_transparent);
    rtcSetGeometryOccludedFilterFunction(geometry, filter_transparent);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

void Geometry::check(const char* doing) const {
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw Error(ErrorCode::temporary, fmt::format("{}: out of memory", doing));
  throw Error(ErrorCode::internal, fmt::format("{}: Embree reports error {}", doing, static_cast<int>(error)));
}

glm::vec3 TransparentHits::tint_before(float distance) const {
  glm::vec3 tint(1.0f);
  for (const One& one : passed)
    if (one.distance < distance) tint *= one.tint;
  return tint;
}

Found Geometry::closest(const Ray& ray) const {
  Context context(this, &ray);
  RTCRayHit found{embree_ray(ray), {}};
  found.hit.geomID = found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(top_.get(), &context.embree, &found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {std::nullopt, std::move(context.transparent)};
  const std::uint32_t object = found.hit.instID[0] == RTC_INVALID_GEOMETRY_ID ? found.hit.geomID : found.hit.instID[0];
  return {Hit{object, found.hit.primID, found.hit.u, found.hit.v, found.ray.tfar}, std::move(context.transparent)};
}

glm::vec3 Geometry::transmitted(const Ray& ray) const {
  Context context(this, &ray);
  RTCRay r = embree_ray(ray);
  rtcOccluded1(top_.get(), &context.embree, &r);
  if (r.tfar < 0.0f) return glm::vec3(0.0f);
  return context.transparent.tint_before(std::numeric_limits<float>::infinity());
}

bool Geometry::lets_through(Context& context, std::uint32_t object, std::uint32_t triangle, float u, float v,
                            float distance) const {
  const SurfacePoint p = surface_point(objects_[object], triangle, u, v);
  const std::uint32_t fate = fate_of(context.ray->chance, object, triangle);
  const Footprint footprint{context.ray->cone_at(distance), shading::hash_to_float(fate)};
  const Transparency transparency = materials_.transparency(p, footprint);
  if (shading::unit_float(fate) < transparency.opacity) return false;
  if (transparency.tint != glm::vec3(1.0f)) context.transparent.passed.push_back({distance, transparency.tint});
  return true;
}

// Rays come one at a time: N is 1.
void Geometry::filter_transparent(const RTCFilterFunctionNArguments* arguments) {
  VEL_ASSERT(arguments->N == 1);
  if (arguments->valid[0] == 0) return;
  Context& context = Context::of(arguments);
  const unsigned instance = RTCHitN_instID(arguments->hit, 1, 0, 0), id = RTCHitN_geomID(arguments->hit, 1, 0);
  const std::uint32_t object = instance == RTC_INVALID_GEOMETRY_ID ? id : instance;
  if (context.geometry->lets_through(context, object, RTCHitN_primID(arguments->hit, 1, 0),
                                     RTCHitN_u(arguments->hit, 1, 0), RTCHitN_v(arguments->hit, 1, 0),
                                     RTCRayN_tfar(arguments->ray, 1, 0)))
    arguments->valid[0] = 0;
}

// The normal and the ray of the filter are in one space, the object's for instances; there fronts are never mirrored.
void Geometry::filter_back_faces(const RTCFilterFunctionNArguments* arguments) {
  VEL_ASSERT(arguments->N == 1);
  if (arguments->valid[0] == 0) return;
  const Geometry& geometry = *Context::of(arguments).geometry;
  const unsigned instance = RTCHitN_instID(arguments->hit, 1, 0, 0), id = RTCHitN_geomID(arguments->hit, 1, 0);
  const bool flat = instance == RTC_INVALID_GEOMETRY_ID;
  const Object& object = geometry.objects_[flat ? id : instance];
  if (geometry.materials_.double_sided(object.material)) return;
  const glm::vec3 normal(RTCHitN_Ng_x(arguments->hit, 1, 0), RTCHitN_Ng_y(arguments->hit, 1, 0),
                         RTCHitN_Ng_z(arguments->hit, 1, 0));
  const glm::vec3 direction(RTCRayN_dir_x(arguments->ray, 1, 0), RTCRayN_dir_y(arguments->ray, 1, 0),
                            RTCRayN_dir_z(arguments->ray, 1, 0));
  const float away = glm::dot(normal, direction) * (flat ? object.handedness : 1.0f);
  if (away > 0.0f) arguments->valid[0] = 0;
}

}  // namespace velarium::reference
