// Inverse dynamics of the Panda-like arm by the recursive Newton-Euler algorithm, hand-written for
// this arm. Rotations by right angles are permutations, zero terms are omitted, and unused
// quantities are not computed. Accelerations and moments use the matrix U = S(w') + S(w) S(w),
// S(w) r = w x r, of Balafoutis and Patel (1991). All numbers are parameters, as in
// models/panda7.toml. Inlining is forced: without it, code of g++ 12 takes 1.6 times as long.
#pragma once

#include <array>
#include <cmath>

namespace bench {

/// About the centre of mass, in the axes of the link.
template <class Scalar>
struct Inertia {
  Scalar xx, yy, zz, xy, xz, yz;
};

template <class Scalar>
struct Vector {
  Scalar x, y, z;
};

template <class Scalar>
struct PandaLink {
  Scalar mass;
  Vector<Scalar> com;
  Inertia<Scalar> inertia;
};

template <class Scalar>
struct Panda {
  std::array<PandaLink<Scalar>, 7> link;
  /// Lengths in m, g in m/s^2. No equation contains the shoulder's height d1.
  Scalar d3, a4, a5, d5, a7, g;
};

namespace panda_detail {

template <class Scalar>
[[gnu::always_inline]] inline Vector<Scalar> operator+(const Vector<Scalar>& a,
                                                       const Vector<Scalar>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Scalar>
[[gnu::always_inline]] inline Vector<Scalar> cross(const Vector<Scalar>& a,
                                                   const Vector<Scalar>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Sine and cosine of a joint angle.
template <class Scalar>
struct JointRotation {
  Scalar s, c;
};

/// Rz(q)^T Rx(Sign * 90 degrees)^T a: from the axes of the parent to the axes of the link.
template <int Sign, class Scalar>
[[gnu::always_inline]] inline Vector<Scalar> outward(const JointRotation<Scalar>& q,
                                                     const Vector<Scalar>& a) {
  if constexpr (Sign > 0) {
    return {q.c * a.x + q.s * a.z, q.c * a.z - q.s * a.x, -a.y};
  } else {
    return {q.c * a.x - q.s * a.z, -(q.s * a.x + q.c * a.z), a.y};
  }
}

/// Rx(Sign * 90 degrees) Rz(q) a: from the axes of the link to the axes of its parent.
template <int Sign, class Scalar>
[[gnu::always_inline]] inline Vector<Scalar> inward(const JointRotation<Scalar>& q,
                                                    const Vector<Scalar>& a) {
  if constexpr (Sign > 0) {
    return {q.c * a.x - q.s * a.y, -a.z, q.s * a.x + q.c * a.y};
  } else {
    return {q.c * a.x - q.s * a.y, a.z, -(q.s * a.x + q.c * a.y)};
  }
}

/// Rotation of a link: angular velocity w, its derivative w', and the entries of U.
template <class Scalar>
struct Rotation {
  Vector<Scalar> w, dw;
  Scalar wxwy, wxwz, wywz;
  Scalar uxx, uyy, uzz, uxy, uxz, uyz, uyx, uzx, uzy;
};

template <class Scalar>
[[gnu::always_inline]] inline Rotation<Scalar> rotation(const Vector<Scalar>& w,
                                                        const Vector<Scalar>& dw) {
  const Scalar xx = w.x * w.x, yy = w.y * w.y, zz = w.z * w.z;
  const Scalar xy = w.x * w.y, xz = w.x * w.z, yz = w.y * w.z;
  return {w,          dw,        xy,        xz,        yz,        -(yy + zz), -(xx + zz),
          -(xx + yy), xy - dw.z, xz + dw.y, yz - dw.x, xy + dw.z, xz - dw.y,  yz + dw.x};
}

/// The rotation of a link whose joint has rate v and acceleration a.
template <int Sign, class Scalar>
[[gnu::always_inline]] inline Rotation<Scalar> rotation_of_link(const JointRotation<Scalar>& q,
                                                                const Rotation<Scalar>& parent,
                                                                const Scalar& v, const Scalar& a) {
  const Vector<Scalar> w = outward<Sign>(q, parent.w);
  const Vector<Scalar> dw = outward<Sign>(q, parent.dw);
  return rotation<Scalar>({w.x, w.y, w.z + v}, {dw.x + w.y * v, dw.y - w.x * v, dw.z + a});
}

/// U c
template <class Scalar>
[[gnu::always_inline]] inline Vector<Scalar> times(const Rotation<Scalar>& r,
                                                   const Vector<Scalar>& c) {
  return {r.uxx * c.x + r.uxy * c.y + r.uxz * c.z, r.uyx * c.x + r.uyy * c.y + r.uyz * c.z,
          r.uzx * c.x + r.uzy * c.y + r.uzz * c.z};
}

/// Inertial force m (at + U c) of a link whose origin has acceleration `at`.
template <class Scalar>
[[gnu::always_inline]] inline Vector<Scalar> force(const PandaLink<Scalar>& link,
                                                   const Rotation<Scalar>& r,
                                                   const Vector<Scalar>& at) {
  const Vector<Scalar> sum = at + times(r, link.com);
  return {link.mass * sum.x, link.mass * sum.y, link.mass * sum.z};
}

/// I w' + w x I w + c x f: the moment about the origin of the link, computed with the entries of U.
template <class Scalar>
[[gnu::always_inline]] inline Vector<Scalar> moment(const PandaLink<Scalar>& link,
                                                    const Rotation<Scalar>& r,
                                                    const Vector<Scalar>& f) {
  const Inertia<Scalar>& i = link.inertia;
  const Vector<Scalar> about_com{
      i.xx * r.dw.x + (i.zz - i.yy) * r.wywz - i.xy * r.uzx + i.xz * r.uyx + i.yz * (r.uyy - r.uzz),
      i.yy * r.dw.y + (i.xx - i.zz) * r.wxwz - i.yz * r.uxy + i.xy * r.uzy + i.xz * (r.uzz - r.uxx),
      i.zz * r.dw.z + (i.yy - i.xx) * r.wxwy - i.xz * r.uyz + i.yz * r.uxz + i.xy * (r.uxx - r.uyy),
  };
  return about_com + cross(link.com, f);
}

/// Motion of a link: its rotation and the acceleration of its origin. Gravity is an upward
/// acceleration of the base.
template <class Scalar>
struct Motion {
  Rotation<Scalar> rotation;
  Vector<Scalar> origin;
};

/// A force, and a moment about the origin of a link.
template <class Scalar>
struct Load {
  Vector<Scalar> force, moment;
};

template <class Scalar>
using Joints = std::array<Scalar, 7>;

/// The motions of links 2 to 7. Link 1 only rotates about the vertical and needs no Motion.
template <class Scalar>
[[gnu::always_inline]] inline std::array<Motion<Scalar>, 6> motions(
    const Panda<Scalar>& p, const std::array<JointRotation<Scalar>, 7>& turn,
    const Joints<Scalar>& v, const Joints<Scalar>& a) {
  const auto& [s2, c2] = turn[1];
  const Scalar w2x = -s2 * v[0], w2y = -c2 * v[0];
  const Motion<Scalar> link2{
      rotation<Scalar>({w2x, w2y, v[1]}, {w2y * v[1] - s2 * a[0], -(w2x * v[1] + c2 * a[0]), a[1]}),
      {-s2 * p.g, -c2 * p.g, Scalar(0)}};

  const auto& [r2, at2] = link2;
  const Vector<Scalar> end2{at2.x - p.d3 * r2.uxy, at2.y - p.d3 * r2.uyy, -p.d3 * r2.uzy};
  const Motion<Scalar> link3{rotation_of_link<1>(turn[2], r2, v[2], a[2]),
                             outward<1>(turn[2], end2)};

  const auto& [r3, at3] = link3;
  const Vector<Scalar> end3{at3.x + p.a4 * r3.uxx, at3.y + p.a4 * r3.uyx, at3.z + p.a4 * r3.uzx};
  const Motion<Scalar> link4{rotation_of_link<1>(turn[3], r3, v[3], a[3]),
                             outward<1>(turn[3], end3)};

  const auto& [r4, at4] = link4;
  const Vector<Scalar> end4{at4.x + p.a5 * r4.uxx + p.d5 * r4.uxy,
                            at4.y + p.a5 * r4.uyx + p.d5 * r4.uyy,
                            at4.z + p.a5 * r4.uzx + p.d5 * r4.uzy};
  const Motion<Scalar> link5{rotation_of_link<-1>(turn[4], r4, v[4], a[4]),
                             outward<-1>(turn[4], end4)};

  const Motion<Scalar> link6{rotation_of_link<1>(turn[5], link5.rotation, v[5], a[5]),
                             outward<1>(turn[5], link5.origin)};

  const auto& [r6, at6] = link6;
  const Vector<Scalar> end6{at6.x + p.a7 * r6.uxx, at6.y + p.a7 * r6.uyx, at6.z + p.a7 * r6.uzx};
  const Motion<Scalar> link7{rotation_of_link<1>(turn[6], r6, v[6], a[6]),
                             outward<1>(turn[6], end6)};
  return {link2, link3, link4, link5, link6, link7};
}

/// The load of the link itself, without its descendants.
template <class Scalar>
[[gnu::always_inline]] inline Load<Scalar> own_load(const PandaLink<Scalar>& link,
                                                    const Motion<Scalar>& motion) {
  const Vector<Scalar> f = force(link, motion.rotation, motion.origin);
  return {f, moment(link, motion.rotation, f)};
}

/// A load expressed in the axes of the parent.
template <int Sign, class Scalar>
[[gnu::always_inline]] inline Load<Scalar> inward(const JointRotation<Scalar>& q,
                                                  const Load<Scalar>& load) {
  return {inward<Sign>(q, load.force), inward<Sign>(q, load.moment)};
}

template <class Scalar>
[[gnu::always_inline]] inline Load<Scalar> operator+(const Load<Scalar>& own,
                                                     const Load<Scalar>& further) {
  return {own.force + further.force, own.moment + further.moment};
}

/// `load` = (f, n) with the moment n about (x, 0, 0) moved to the origin: n + (x, 0, 0) x f.
template <class Scalar>
[[gnu::always_inline]] inline Load<Scalar> at(const Scalar& x, const Load<Scalar>& load) {
  const auto& [f, n] = load;
  return {f, {n.x, n.y - x * f.z, n.z + x * f.y}};
}

/// The moment of link 1 on link 2 about the origin of link 2. `from3` is the load of link 3 in the
/// axes of link 2.
template <class Scalar>
[[gnu::always_inline]] inline Vector<Scalar> shoulder_moment(const Panda<Scalar>& p,
                                                             const Motion<Scalar>& motion,
                                                             const Load<Scalar>& from3) {
  const auto& [r, origin] = motion;
  const PandaLink<Scalar>& link = p.link[1];
  const Vector<Scalar> from_com = times(r, link.com);
  const Vector<Scalar> f{link.mass * (origin.x + from_com.x), link.mass * (origin.y + from_com.y),
                         link.mass * from_com.z};
  const Vector<Scalar> n = moment(link, r, f) + from3.moment;
  return {n.x - p.d3 * from3.force.z, n.y, n.z + p.d3 * from3.force.x};
}

}  // namespace panda_detail

/// Torques of the seven joints.
template <class Scalar>
std::array<Scalar, 7> inverse_dynamics(const Panda<Scalar>& p, const std::array<Scalar, 7>& q,
                                       const std::array<Scalar, 7>& v,
                                       const std::array<Scalar, 7>& a) {
  using namespace panda_detail;
  using std::cos;
  using std::sin;
  std::array<JointRotation<Scalar>, 7> turn{};
  for (std::size_t i = 1; i < 7; ++i) turn[i] = {sin(q[i]), cos(q[i])};
  const auto [on2, on3, on4, on5, on6, on7] = motions(p, turn, v, a);

  const Load<Scalar> load7 = own_load(p.link[6], on7);
  const Load<Scalar> load6 = own_load(p.link[5], on6) + at(p.a7, inward<1>(turn[6], load7));
  const Load<Scalar> load5 = own_load(p.link[4], on5) + inward<1>(turn[5], load6);
  Load<Scalar> from5 = at(p.a5, inward<-1>(turn[4], load5));
  from5.moment.x = from5.moment.x + p.d5 * from5.force.z;
  from5.moment.z = from5.moment.z - p.d5 * from5.force.x;
  const Load<Scalar> load4 = own_load(p.link[3], on4) + from5;
  const Load<Scalar> load3 = own_load(p.link[2], on3) + at(p.a4, inward<1>(turn[3], load4));
  const Vector<Scalar> n2 = shoulder_moment(p, on2, inward<1>(turn[2], load3));

  const PandaLink<Scalar>& base = p.link[0];
  const Scalar about_axis =
      base.inertia.zz + base.mass * (base.com.x * base.com.x + base.com.y * base.com.y);
  return {about_axis * a[0] - (turn[1].s * n2.x + turn[1].c * n2.y),
          n2.z,
          load3.moment.z,
          load4.moment.z,
          load5.moment.z,
          load6.moment.z,
          load7.moment.z};
}

}  // namespace bench
