/* Loads one kinematics module of LinuxCNC without LinuxCNC and answers questions on standard input:
 *   pin NAME VALUE      sets a pin
 *   again               asks for the type once more; prints whether that made no second pins
 *   switch TYPE         prints the result
 *   inverse X Y Z A B C U V W    prints the result and nine joints
 *   forward J0 .. J8    prints the result and the pose
 *   time COUNT          prints the nanoseconds of one forward and one inverse, mean of COUNT of each
 * Arguments: module, coordinates, sparm; the last two may be empty. The functions of HAL keep the pins in this process.
 */
#include <dlfcn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef struct {
    double x, y, z, a, b, c, u, v, w;
} Pose;

enum { FLOAT, BIT, S32 };
static struct {
    char name[64];
    int kind;
    void *value;
} pins[64];
static int pin_count, is_ready;

static int new_pin(void **to, int kind, const char *name)
{
    if (is_ready || pin_count == 64) return -1;
    snprintf(pins[pin_count].name, sizeof pins[0].name, "%s", name);
    pins[pin_count].kind = kind;
    *to = pins[pin_count++].value = calloc(1, sizeof(double));
    return 0;
}

#define NEWF(kind_name, kind)                                                                    \
    int hal_pin_##kind_name##_newf(int direction, void **to, int component, const char *format, ...) \
    {                                                                                            \
        char name[64];                                                                           \
        va_list arguments;                                                                       \
        (void)direction, (void)component;                                                        \
        va_start(arguments, format);                                                             \
        vsnprintf(name, sizeof name, format, arguments);                                         \
        va_end(arguments);                                                                       \
        return new_pin(to, kind, name);                                                          \
    }                                                                                            \
    int hal_pin_##kind_name##_new(const char *name, int direction, void **to, int component)     \
    {                                                                                            \
        (void)direction, (void)component;                                                        \
        return new_pin(to, kind, name);                                                          \
    }
NEWF(float, FLOAT)
NEWF(bit, BIT)
NEWF(s32, S32)

int hal_init(const char *name) { (void)name; return 1; }
int hal_exit(int component) { (void)component; return 0; }
int hal_ready(int component) { (void)component; is_ready = 1; return 0; }
int hal_set_unready(int component) { (void)component; is_ready = 0; return 0; }
void *hal_malloc(long size) { return calloc(1, size); }
void rtapi_print(const char *format, ...) { (void)format; }
void rtapi_print_msg(int level, const char *format, ...) { (void)level, (void)format; }
int rtapi_snprintf(char *to, unsigned long size, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(to, size, format, arguments);
    va_end(arguments);
    return length;
}

static double *as_array(Pose *pose) { return &pose->x; }

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

int main(int count, char **arguments)
{
    if (count != 4) return 2;
    void *module = dlopen(arguments[1], RTLD_NOW);
    if (!module) {
        fprintf(stderr, "%s\n", dlerror());
        return 2;
    }
    /* Where the parameters of a module are: rtapi.h, RTAPI_MP_STRING. */
    char ***coordinates = dlsym(module, "rtapi_info_address_coordinates");
    char ***sparm = dlsym(module, "rtapi_info_address_sparm");
    if (coordinates && *arguments[2]) **coordinates = arguments[2];
    if (sparm && *arguments[3]) **sparm = arguments[3];
    int (*start)(void) = (int (*)(void))dlsym(module, "rtapi_app_main");
    int (*type)(void) = (int (*)(void))dlsym(module, "kinematicsType");
    int (*change)(int) = (int (*)(int))dlsym(module, "kinematicsSwitch");
    int (*forward)(const double *, Pose *, const unsigned long *, unsigned long *) =
        (int (*)(const double *, Pose *, const unsigned long *, unsigned long *))dlsym(module, "kinematicsForward");
    int (*inverse)(const Pose *, double *, const unsigned long *, unsigned long *) =
        (int (*)(const Pose *, double *, const unsigned long *, unsigned long *))dlsym(module, "kinematicsInverse");
    if (!start || !type || !change || !forward || !inverse || start() || type() != 4 || !is_ready) return 3;

    /* Each answer leaves at once: the other side waits for it. */
    setvbuf(stdout, NULL, _IOLBF, 0);
    char line[1024];
    unsigned long flags = 0, other = 0;
    while (fgets(line, sizeof line, stdin)) {
        char word[16], name[64];
        double n[9] = {0};
        int taken = 0;
        if (sscanf(line, "pin %63s %lf", name, n) == 2) {
            int found = 0;
            for (int i = 0; i < pin_count; i++) {
                if (strcmp(pins[i].name, name)) continue;
                found = 1;
                if (pins[i].kind == FLOAT) *(double *)pins[i].value = n[0];
            }
            printf("%d\n", found);
            continue;
        }
        if (sscanf(line, "get %63s", name) == 1) {
            for (int i = 0; i < pin_count; i++)
                if (!strcmp(pins[i].name, name)) printf("%d\n", pins[i].kind == BIT ? *(char *)pins[i].value : -1);
            continue;
        }
        sscanf(line, "%15s%n", word, &taken);
        char *rest = line + taken;
        for (int i = 0; i < 9; i++) n[i] = strtod(rest, &rest);
        Pose pose;
        double joints[16];
        memset(joints, 0, sizeof joints);
        memset(&pose, 0, sizeof pose);
        if (!strcmp(word, "again")) {
            const int made = pin_count;
            printf("%d\n", type() == 4 && pin_count == made);
        } else if (!strcmp(word, "switch")) {
            printf("%d\n", change((int)n[0]));
        } else if (!strcmp(word, "forward")) {
            memcpy(joints, n, sizeof n);
            printf("%d", forward(joints, &pose, &flags, &other));
            for (int i = 0; i < 9; i++) printf(" %.17g", as_array(&pose)[i]);
            printf("\n");
        } else if (!strcmp(word, "inverse")) {
            memcpy(as_array(&pose), n, sizeof n);
            printf("%d", inverse(&pose, joints, &other, &flags));
            for (int i = 0; i < 9; i++) printf(" %.17g", joints[i]);
            printf("\n");
        } else if (!strcmp(word, "time")) {
            const double from = seconds();
            for (int i = 0; i < (int)n[0]; i++) {
                Pose at = {10.0 + i % 7, -20.0, 30.0, 11.0, 12.0, 13.0 + i % 5, 0.0, 0.0, 0.0};
                inverse(&at, joints, &other, &flags);
                forward(joints, &pose, &flags, &other);
            }
            printf("%.3f\n", (seconds() - from) / n[0] * 1e9);
        } else {
            return 5;
        }
    }
    return 0;
}
