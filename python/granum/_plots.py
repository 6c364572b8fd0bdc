# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of results by matplotlib, which is imported only here.

Each function becomes the method plot() of a class, and draws on the given axes.
"""

from __future__ import annotations

import importlib

import numpy as np

from ._granum import Fabric, Inference, Ladder, Packing, SandInference, Study, fabric_density

# Meaning of colours in all pictures of granum: rows of include/granum/plot/palette.hpp.
_CLOSED_FORM, _MEASURED, _FORCE, _GREY = "#a2457e", "#474f5a", "#b3261e", "#6b6f75"
_SHAPES = {"sphere": "o", "cone": "^", "flat": "s"}


def _axes(ax, **keywords):
    """The axes given, or new ones of a new figure."""
    if ax is not None:
        return ax
    pyplot = importlib.import_module("matplotlib.pyplot")
    return pyplot.subplots(subplot_kw=keywords)[1]


def _plain_numbers(ax):
    """Writes 200 instead of 2 x 10^2 on a logarithmic axis."""
    ticker = importlib.import_module("matplotlib.ticker")
    for axis in (ax.xaxis, ax.yaxis):
        axis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
        axis.set_minor_locator(ticker.NullLocator())
        axis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value:g}"))


def _ladder(self, ax=None):
    """Stated error of each rung against its computing time, with the tolerance."""
    ax = _axes(ax)
    for rung in self.rungs:
        error = rung.largest_error
        if not error:  # not stated or 0: neither can be shown on a logarithmic axis
            continue
        chosen = rung.rung == self.choice.rung
        ax.plot(rung.typical_time, 100 * error, "o", color=_CLOSED_FORM if chosen else _GREY)
        ax.annotate(
            f"rung {rung.rung}",
            (rung.typical_time, 100 * error),
            xytext=(6, 4),
            textcoords="offset points",
            fontsize="small",
            fontweight="bold" if chosen else "normal",
        )
    ax.axhline(100 * self.tolerance, color="0.4", linestyle="--", label="tolerance")
    ax.set(xscale="log", yscale="log", xlabel="time of one evaluation [s]", ylabel="stated error [%]")
    ax.margins(x=0.3, y=0.2)
    ax.legend(loc="lower right")
    return ax


def _rose(self, ax=None):
    """Density of contact normals by the angle from the vertical, with standard errors, and E(gamma; a) for comparison.
    """
    ax = _axes(ax, projection="polar")
    low = np.array([part.low for part in self.rose])
    high = np.array([part.high for part in self.rose])
    density = np.array([part.density for part in self.rose])
    error = np.array([part.density_error for part in self.rose])
    for k, turn in enumerate((lambda g: g, lambda g: np.pi - g, lambda g: np.pi + g, lambda g: -g)):
        ax.bar(
            turn((low + high) / 2),
            density,
            width=high - low,
            yerr=error,
            color=_MEASURED,
            alpha=0.4,
            ecolor="0.2",
            capsize=2,
            label="counted" if k == 0 else None,
        )
    anisotropy = self.anisotropy if self.likeliest_anisotropy is None else self.likeliest_anisotropy
    angle = np.linspace(0, 2 * np.pi, 361)
    ax.plot(
        angle,
        fabric_density(polar_angle=np.arccos(np.abs(np.cos(angle))), anisotropy=anisotropy),
        color=_CLOSED_FORM,
        label=f"E(γ; a = {anisotropy:.2g})",
    )
    ax.set_theta_zero_location("N")
    ax.set_theta_direction(-1)
    ax.legend(loc="lower right", bbox_to_anchor=(1.15, -0.1), fontsize="small")
    return ax


def _study(self, ax=None):
    """G_vh against p, both logarithmic: closed form, contact network and probe for every specimen."""
    ax = _axes(ax)
    states = {name: np.asarray(column) for name, column in self.states.items()}
    specimens = zip(states["contact"], states["density"], states["seed"])
    for contact, density, seed in dict.fromkeys(specimens):
        of_it = (
            (states["contact"] == contact) & (states["density"] == density) & (states["seed"] == seed)
        )
        pressure = states["p_Pa"][of_it] / 1e3
        style = {
            "marker": _SHAPES.get(contact, "D"),
            "fillstyle": "full" if density == "dense" else "none",
            "markersize": 5,
        }
        ax.plot(pressure, states["G_closed_Pa"][of_it] / 1e6, ":", color=_CLOSED_FORM, **style)
        ax.plot(pressure, states["G_vh_network_Pa"][of_it] / 1e6, "-", color=_MEASURED, **style)
        ax.plot(
            pressure,
            states["G_vh_probe_Pa"][of_it] / 1e6,
            "x",
            color=_MEASURED,
            markersize=9,
        )
        ax.annotate(
            f"{contact}, {density}",
            (pressure[-1], states["G_vh_network_Pa"][of_it][-1] / 1e6),
            xytext=(6, 0),
            textcoords="offset points",
            fontsize="small",
            va="center",
        )
    meanings = [(_CLOSED_FORM, ":", "closed form"), (_MEASURED, "-", "contact network")]
    if np.any(np.isfinite(states["G_vh_probe_Pa"])):
        meanings.append((_MEASURED, "x", "DEM probe"))
    for colour, line, label in meanings:
        ax.plot([], [], line, color=colour, label=label)
    ax.set(xscale="log", yscale="log", xlabel="p [kPa]", ylabel="G_vh [MPa]")
    _plain_numbers(ax)
    ax.margins(x=0.25)
    ax.legend(fontsize="small")
    return ax


def _chains(self, ax=None, *, across=0, up=2):
    """Contacts as lines between centres, as wide as their normal forces, seen along the third axis.

    Contacts through a periodic face are left out.

    Parameters
    ----------
    across, up : int
        Axes of the packing, 0 to 2, shown horizontally and vertically.
    """
    ax = _axes(ax)
    collections = importlib.import_module("matplotlib.collections")
    contacts = self.contacts
    start = self.position[contacts.i]
    inside = np.linalg.norm(self.position[contacts.j] - start - contacts.branch, axis=1) <= 1e-6 * (
        np.linalg.norm(contacts.branch, axis=1)
    )
    start, branch, force = start[inside], contacts.branch[inside], contacts.normal_force[inside]
    mean = force[force > 0].mean() if np.any(force > 0) else 1.0
    lines = np.stack([start, start + branch], axis=1)[:, :, [across, up]] * 1e3
    ax.add_collection(
        collections.LineCollection(lines, linewidths=np.clip(force / mean, 0, 8), colors=_FORCE, alpha=0.7)
    )
    ax.autoscale_view()
    names = "xyz"
    ax.set(aspect="equal", xlabel=f"{names[across]} [mm]", ylabel=f"{names[up]} [mm]")
    return ax


def _inference(self, ax=None, *, quantity="G", pressure):
    """A quantity predicted from all measurements against the pressure, with its standard error.

    Parameters
    ----------
    quantity : str
        G, G_hh, K, V_s, V_s_hh, V_p or V_p_h.
    pressure : array_like
        Pressures of the prediction [Pa].
    """
    ax = _axes(ax)
    pressure = np.asarray(pressure, dtype=float)
    found = self.predict(quantity, pressure=pressure)
    scale, unit = (1, "m/s") if quantity.startswith("V") else (1e6, "MPa")
    ax.plot(pressure / 1e3, found.value / scale, color=_CLOSED_FORM)
    ax.fill_between(
        pressure / 1e3,
        (found.value - found.standard_error) / scale,
        (found.value + found.standard_error) / scale,
        color=_CLOSED_FORM,
        alpha=0.2,
        linewidth=0,
        label="± one standard error",
    )
    ax.set(xscale="log", yscale="log", xlabel="p [kPa]", ylabel=f"{quantity} [{unit}]")
    _plain_numbers(ax)
    ax.legend(fontsize="small")
    return ax


# What the docstrings of all of them say.
_PARAMETERS = """

    Parameters
    ----------
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: those of a new figure.
"""
_RETURNS = """
    Returns
    -------
    matplotlib.axes.Axes
    """


def _attach():
    """Makes each function the method plot of its class."""
    for type_, function in (
        (Ladder, _ladder),
        (Fabric, _rose),
        (Study, _study),
        (Packing, _chains),
        (SandInference, _inference),
        (Inference, _inference),
    ):
        summary, _, others = (function.__doc__ or "").rstrip().partition("\n\n    Parameters\n    ----------\n")
        if "matplotlib" not in others:
            function.__doc__ = summary + _PARAMETERS + (others and others + "\n") + _RETURNS
        function.__name__ = "plot"
        function.__qualname__ = f"{type_.__name__}.plot"
        type_.plot = function
