/* SPDX-License-Identifier: MIT */
/* The calls that are made one at a time: a point, or a derivative, at one parameter. ctypes and the handling of any array
 * take some ten microseconds of each, the library a few hundredths of one.
 *
 * What is not quite usual is left to the Python code by returning None: arrays, other outputs, and everything that is an
 * error, so that there is one place that says what is wrong. The library is not linked: _library.py, which has loaded it,
 * hands its functions over. Of Python's interface only the stable one is used. */
#define Py_LIMITED_API 0x030b0000
#define PY_SSIZE_T_CLEAN
#include <Python.h>
#include <stdint.h>
#include <string.h>

typedef int32_t (*EvalFunction)(const void *, int64_t, const double *, int64_t, int64_t, double *, int64_t,
                                int64_t, uint32_t);
typedef int32_t (*DerivsFunction)(const void *, int32_t, int64_t, const double *, int64_t, int64_t, double *,
                                  int64_t, int64_t, uint32_t);

typedef struct {
    EvalFunction eval;
    DerivsFunction derivs;
    PyObject *empty; /* numpy.empty */
} State;

enum { most_axes = 3, most_order = 8, most_values = 1024 };

/* What all calls begin with: handle, axes, dimension, params, and flags at the end. */
typedef struct {
    const void *handle;
    int axes;
    int64_t dim;
    double at[most_axes];
    uint32_t flags;
} Place;

/* An exact number; NumPy's float64 is a float of Python. */
static int read_number(PyObject *value, double *out) {
    if (!PyFloat_Check(value) && !PyLong_CheckExact(value)) {
        return 0;
    }
    *out = PyFloat_AsDouble(value);
    if (*out == -1 && PyErr_Occurred()) {
        PyErr_Clear();
        return 0;
    }
    return 1;
}

static int read_params(PyObject *params, Place *place) {
    if (place->axes == 1) {
        return read_number(params, &place->at[0]);
    }
    const int tuple = PyTuple_CheckExact(params);
    if (!(tuple || PyList_CheckExact(params)) ||
        (tuple ? PyTuple_Size(params) : PyList_Size(params)) != place->axes) {
        return 0;
    }
    for (int k = 0; k < place->axes; ++k) {
        if (!read_number(tuple ? PyTuple_GetItem(params, k) : PyList_GetItem(params, k), &place->at[k])) {
            return 0;
        }
    }
    return 1;
}

/* The handle is an integer, or None of a spline that could not be made. */
static int read_place(PyObject *const *args, PyObject *flags, Place *place) {
    if (!PyLong_CheckExact(args[0]) || !PyLong_CheckExact(flags)) {
        return 0;
    }
    place->handle = PyLong_AsVoidPtr(args[0]);
    place->axes = (int)PyLong_AsLong(args[1]);
    place->dim = PyLong_AsLongLong(args[2]);
    const long long wanted = PyLong_AsLongLong(flags);
    place->flags = (uint32_t)wanted;
    if (PyErr_Occurred()) {
        PyErr_Clear();
        return 0;
    }
    return wanted >= 0 && wanted <= UINT32_MAX && place->axes >= 1 && place->axes <= most_axes &&
           read_params(args[3], place);
}

/* numpy.empty(dim) with the values, or a new reference to None where that is not what Python has made. */
static PyObject *array_of(const State *state, PyObject *dim, int64_t size, const double *values) {
    PyObject *array = PyObject_CallFunctionObjArgs(state->empty, dim, NULL);
    Py_buffer view;
    if (array == NULL || PyObject_GetBuffer(array, &view, PyBUF_WRITABLE) != 0) {
        Py_XDECREF(array);
        return NULL;
    }
    memcpy(view.buf, values, sizeof(double) * (size_t)size);
    PyBuffer_Release(&view);
    return array;
}

static PyObject *none(void) {
    return Py_NewRef(Py_None);
}

/* eval(handle, axes, dimension, params, flags): the point (dimension,). */
static PyObject *single_eval(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    const State *state = PyModule_GetState(module);
    Place place;
    double values[most_values];
    if (count != 5 || state->eval == NULL || !read_place(args, args[4], &place) || place.dim > most_values) {
        return none();
    }
    int32_t status = 0;
    Py_BEGIN_ALLOW_THREADS;
    status = state->eval(place.handle, 1, place.at, 0, 0, values, 0, 0, place.flags);
    Py_END_ALLOW_THREADS;
    return status == 0 ? array_of(state, args[2], place.dim, values) : none();
}

/* The order of the derivative along each axis: an integer of a curve, otherwise one for each axis. */
static int read_orders(PyObject *nu, int axes, long orders[most_axes]) {
    const int tuple = PyTuple_CheckExact(nu);
    if (axes > 1 && (!tuple || PyTuple_Size(nu) != axes)) {
        return 0;
    }
    long total = 0;
    for (int k = 0; k < axes; ++k) {
        PyObject *order = axes == 1 ? nu : PyTuple_GetItem(nu, k);
        orders[k] = PyLong_CheckExact(order) ? PyLong_AsLong(order) : -1;
        if (orders[k] < 0 || orders[k] > most_order) {
            PyErr_Clear();
            return 0;
        }
        total += orders[k];
    }
    return total <= most_order;
}

/* The number of slots of orders below `order`, which is binomial(order - 1 + axes, axes). */
static int64_t slots_below(long order, int axes) {
    const int64_t s = order;
    return axes == 1 ? s : axes == 2 ? s * (s + 1) / 2 : s * (s + 1) * (s + 2) / 6;
}

/* As derivative_slot() of the Python code says. */
static int64_t slot_of(const long *orders, int axes) {
    int64_t slot = 0;
    for (int k = 0; k < axes; ++k) {
        long rest = 0;
        for (int j = k; j < axes; ++j) {
            rest += orders[j];
        }
        slot += slots_below(rest, axes - k);
    }
    return slot;
}

/* derivative(handle, axes, dimension, params, nu, flags): the derivative (dimension,) of orders nu. */
static PyObject *single_derivative(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    const State *state = PyModule_GetState(module);
    Place place;
    long orders[most_axes] = {0};
    double values[most_values];
    if (count != 6 || state->derivs == NULL || !read_place(args, args[5], &place) ||
        !read_orders(args[4], place.axes, orders)) {
        return none();
    }
    const long order = orders[0] + orders[1] + orders[2];
    if (order == 0 || place.dim > most_values / slots_below(order + 1, place.axes)) {
        return none();
    }
    int32_t status = 0;
    Py_BEGIN_ALLOW_THREADS;
    status = state->derivs(place.handle, (int32_t)order, 1, place.at, 0, 0, values, 0, 0, place.flags);
    Py_END_ALLOW_THREADS;
    return status == 0 ? array_of(state, args[2], place.dim, values + slot_of(orders, place.axes) * place.dim)
                       : none();
}

/* bind(address of nurbs_eval, address of nurbs_eval_derivs, numpy.empty) */
static PyObject *single_bind(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    State *state = PyModule_GetState(module);
    if (count != 3) {
        PyErr_SetString(PyExc_TypeError, "bind() takes two addresses and a function");
        return NULL;
    }
    void *eval = PyLong_AsVoidPtr(args[0]), *derivs = PyLong_AsVoidPtr(args[1]);
    if (PyErr_Occurred()) {
        return NULL;
    }
    *(void **)(void *)&state->eval = eval;
    *(void **)(void *)&state->derivs = derivs;
    Py_XDECREF(state->empty);
    state->empty = Py_NewRef(args[2]);
    return none();
}

static int traverse(PyObject *module, visitproc visit, void *arg) {
    const State *state = PyModule_GetState(module);
    Py_VISIT(state->empty);
    return 0;
}

static int clear(PyObject *module) {
    State *state = PyModule_GetState(module);
    Py_CLEAR(state->empty);
    return 0;
}

static PyMethodDef methods[] = {
    {"bind", (PyCFunction)(void (*)(void))single_bind, METH_FASTCALL,
     "Hands the functions of the library over."},
    {"eval", (PyCFunction)(void (*)(void))single_eval, METH_FASTCALL, "A point, or None."},
    {"derivative", (PyCFunction)(void (*)(void))single_derivative, METH_FASTCALL, "A derivative, or None."},
    {NULL, NULL, 0, NULL},
};

static PyModuleDef_Slot slots[] = {{0, NULL}};

static PyModuleDef definition = {PyModuleDef_HEAD_INIT,
                                 "nurbs._single",
                                 "Calls that are made one at a time.",
                                 sizeof(State),
                                 methods,
                                 slots,
                                 traverse,
                                 clear,
                                 NULL};

PyMODINIT_FUNC PyInit__single(void) {
    return PyModuleDef_Init(&definition);
}
