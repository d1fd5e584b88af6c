// bullet_inverse_dynamics.hpp: what the tests use of libBulletInverseDynamics-float64.
//
// Debian packages that library without its C++ headers; these declarations follow the symbols that it exports. A symbol
// that is not as declared fails to link.
#pragma once

#include <LinearMath/btMatrix3x3.h>
#include <LinearMath/btMatrixX.h>
#include <LinearMath/btVector3.h>

#include <array>
#include <cstddef>

namespace btInverseDynamicsBullet3
{

class vec3 : public btVector3
{
  public:
    explicit vec3(const btVector3 &vector) : btVector3(vector)
    {
    }
};

class mat33 : public btMatrix3x3
{
  public:
    explicit mat33(const btMatrix3x3 &matrix) : btMatrix3x3(matrix)
    {
    }
};

class vecx : public btVectorX<double>
{
  public:
    explicit vecx(int size) : btVectorX<double>(size)
    {
        setZero();
    }
};

enum JointType { FIXED = 0, REVOLUTE = 1 };

// A tree of bodies, each in the frame of the joint that carries it. Functions return 0, or -1 on an error.
class MultiBodyTree
{
  public:
    MultiBodyTree();
    ~MultiBodyTree();
    MultiBodyTree(const MultiBodyTree &) = delete;
    MultiBodyTree &operator=(const MultiBodyTree &) = delete;

    // Body `index` hangs on `parent` (-1: the world), parents first. The rotation takes vectors of the parent's frame
    // into the body's at angle 0; the inertia is about the body frame's origin.
    int addBody(int index, int parent, JointType joint, const vec3 &p_parent_body, const mat33 &rotation_body_parent,
                const vec3 &axis, double mass, const vec3 &p_body_com, const mat33 &inertia, int user_number,
                void *user_pointer);
    int finalize();
    int setGravityInWorldFrame(const vec3 &acceleration);
    // Joint torques of the motion with angles q, velocities u and accelerations dot_u.
    int calculateInverseDynamics(const vecx &q, const vecx &u, const vecx &dot_u, vecx *torques);

  private:
    // Room for the library's own members: three flags and two pointers in Bullet 3.24.
    alignas(std::max_align_t) std::array<std::byte, 128> members_;
};

} // namespace btInverseDynamicsBullet3
