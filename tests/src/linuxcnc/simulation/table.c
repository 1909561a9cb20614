/* Kinematics of a table that rotates about two axes, as a component of LinuxCNC for one machine.
 *
 * Type 0: joints as axes. Type 1: tip control, X Y Z are coordinates of the tip in a frame that rotates with the table.
 * Joints in the order X Y Z B C; C carries the workpiece, B carries C. A rotation is given by its direction (with the
 * sign of the axis) and a point of its centre line in machine coordinates, mm: B_DIRECTION, B_POINT, C_DIRECTION and
 * C_POINT are defined by the command line of the compiler. The component takes the place of `userkins`, the module that
 * LinuxCNC has for kinematics of one's own.
 *
 * The declarations are those of LinuxCNC 2.9 (hal.h, emcpos.h, kinematics.h), whose header files need not be
 * installed.
 */
#include <math.h>

typedef struct {
    double x, y, z, a, b, c, u, v, w;
} EmcPose;

enum { KINEMATICS_BOTH = 4, HAL_IN = 16 };

int hal_init(const char *name);
int hal_ready(int component);
int hal_exit(int component);
void *hal_malloc(long size);
int hal_pin_float_newf(int direction, volatile double **data, int component, const char *format, ...);

typedef struct {
    double direction[3], point[3];
} Rotation;

static const Rotation b_axis = {B_DIRECTION, B_POINT};
static const Rotation c_axis = {C_DIRECTION, C_POINT};

static volatile double **tool_offset;
static int component;
static int type;

/* Rotates a point about a centre line by an angle in degrees (Rodrigues). */
static void rotate(double p[3], const Rotation *about, double degrees)
{
    const double *n = about->direction;
    const double angle = degrees * M_PI / 180.0, s = sin(angle), c = cos(angle);
    const double v[3] = {p[0] - about->point[0], p[1] - about->point[1], p[2] - about->point[2]};
    const double along = (n[0] * v[0] + n[1] * v[1] + n[2] * v[2]) * (1.0 - c);
    const double across[3] = {n[1] * v[2] - n[2] * v[1], n[2] * v[0] - n[0] * v[2], n[0] * v[1] - n[1] * v[0]};
    for (int i = 0; i < 3; i++)
        p[i] = about->point[i] + v[i] * c + across[i] * s + n[i] * along;
}

int kinematicsForward(const double *joints, EmcPose *pose, const unsigned long *fflags, unsigned long *iflags)
{
    double tip[3] = {joints[0], joints[1], joints[2] - **tool_offset};
    (void)fflags, (void)iflags;
    if (type == 1) {
        rotate(tip, &b_axis, joints[3]);
        rotate(tip, &c_axis, joints[4]);
    }
    *pose = (EmcPose){.x = tip[0], .y = tip[1], .z = tip[2] + **tool_offset, .b = joints[3], .c = joints[4]};
    return 0;
}

int kinematicsInverse(const EmcPose *pose, double *joints, const unsigned long *iflags, unsigned long *fflags)
{
    double tip[3] = {pose->x, pose->y, pose->z - **tool_offset};
    (void)fflags, (void)iflags;
    if (type == 1) {
        rotate(tip, &c_axis, -pose->c);
        rotate(tip, &b_axis, -pose->b);
    }
    joints[0] = tip[0];
    joints[1] = tip[1];
    joints[2] = tip[2] + **tool_offset;
    joints[3] = pose->b;
    joints[4] = pose->c;
    return 0;
}

int kinematicsType(void)
{
    return KINEMATICS_BOTH;
}

int kinematicsSwitchable(void)
{
    return 1;
}

int kinematicsSwitch(int wanted)
{
    type = wanted;
    return 0;
}

int rtapi_app_main(void)
{
    component = hal_init("userkins");
    if (component < 0)
        return component;
    tool_offset = hal_malloc(sizeof *tool_offset);
    if (!tool_offset || hal_pin_float_newf(HAL_IN, tool_offset, component, "userkins.tool-offset") < 0)
        return -1;
    return hal_ready(component);
}

void rtapi_app_exit(void)
{
    hal_exit(component);
}
