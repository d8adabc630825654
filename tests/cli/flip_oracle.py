# SPDX-License-Identifier: Apache-2.0
"""An independent FLIP, from the formulas of Andersson et al. 2020 and 2021: plain, with full convolutions
in two dimensions, in double precision. It shares no code and no decomposition with lib/vug/image."""
import numpy as np

PIXELS_PER_DEGREE = 0.7 * 3840 / 0.7 * np.pi / 180
XYZ = np.array([[10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
                [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
                [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382]])
WHITE = XYZ.sum(axis=1)


def convolve(plane, kernel):
    """Correlation with the nearest pixel beyond the border."""
    r, s = kernel.shape[0] // 2, kernel.shape[1] // 2
    padded = np.pad(plane, ((r, r), (s, s)), mode="edge")
    out = np.zeros_like(plane)
    for j in range(kernel.shape[0]):
        for i in range(kernel.shape[1]):
            out += kernel[j, i] * padded[j:j + plane.shape[0], i:i + plane.shape[1]]
    return out


def grid(radius):
    return np.meshgrid(np.arange(-radius, radius + 1.0), np.arange(-radius, radius + 1.0))


def contrast_sensitivity(terms):
    radius = int(np.ceil(3 * np.sqrt(0.04 / (2 * np.pi ** 2)) * PIXELS_PER_DEGREE))
    x, y = grid(radius)
    squared = (x ** 2 + y ** 2) / PIXELS_PER_DEGREE ** 2
    kernel = sum(a * np.sqrt(np.pi / b) * np.exp(-np.pi ** 2 * squared / b) for a, b in terms)
    return kernel / kernel.sum()


def opponent(linear):
    x, y, z = np.moveaxis(linear @ XYZ.T / WHITE, -1, 0)
    return np.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=-1)


def from_opponent(colours):
    y = (colours[..., 0] + 16) / 116
    xyz = np.stack([y + colours[..., 1] / 500, y, y - colours[..., 2] / 200], axis=-1) * WHITE
    return xyz @ np.linalg.inv(XYZ).T


def hunt_lab(linear):
    t = linear @ XYZ.T / WHITE
    d = 6 / 29
    x, y, z = np.moveaxis(np.where(t > d ** 3, np.cbrt(t), t / (3 * d * d) + 4 / 29), -1, 0)
    light = 116 * y - 16
    return np.stack([light, 0.01 * light * 500 * (x - y), 0.01 * light * 200 * (y - z)], axis=-1)


def hyab(a, b):
    d = a - b
    return np.abs(d[..., 0]) + np.hypot(d[..., 1], d[..., 2])


def features(luminance):
    sigma = 0.5 * 0.082 * PIXELS_PER_DEGREE
    x, y = grid(int(np.ceil(3 * sigma)))
    bell = np.exp(-(x ** 2 + y ** 2) / (2 * sigma ** 2))
    found = []
    for kernel in (-x * bell, (x ** 2 / sigma ** 2 - 1) * bell):
        kernel = np.where(kernel > 0, kernel / kernel[kernel > 0].sum(), -kernel / kernel[kernel < 0].sum())
        found.append(np.hypot(convolve(luminance, kernel), convolve(luminance, kernel.T)))
    return found


def look(linear):
    seen = opponent(linear)
    edges, points = features((seen[..., 0] + 16) / 116)
    filters = [contrast_sensitivity(t) for t in ([(1, 0.0047)], [(1, 0.0053)], [(34.1, 0.04), (13.5, 0.025)])]
    soft = np.stack([convolve(seen[..., i], filters[i]) for i in range(3)], axis=-1)
    return hunt_lab(np.clip(from_opponent(soft), 0, 1)), edges, points


def ldr(reference, test):
    """The error map of two screens' linear light in [0, 1], arrays (height, width, 3)."""
    (lab_a, edges_a, points_a), (lab_b, edges_b, points_b) = look(reference), look(test)
    most = hyab(hunt_lab(np.array([0.0, 1, 0])), hunt_lab(np.array([0.0, 0, 1]))) ** 0.7
    error = hyab(lab_a, lab_b) ** 0.7
    bend = 0.4 * most
    colour = np.where(error < bend, 0.95 / bend * error, 0.95 + (error - bend) / (most - bend) * 0.05)
    feature = np.maximum(np.abs(edges_a - edges_b), np.abs(points_a - points_b))
    return colour ** (1 - (feature / np.sqrt(2)) ** 0.5)


def curve(x):
    return np.clip((0.36 * 2.51 * x * x + 0.018 * x) / (0.36 * 2.43 * x * x + 0.354 * x + 0.14), 0, 1)


def hdr(reference, test):
    """The error map over the range of exposures that the reference determines."""
    p = (0.018 - 0.354 * 0.85) / (0.36 * 2.51 - 0.36 * 2.43 * 0.85)
    q = -0.14 * 0.85 / (0.36 * 2.51 - 0.36 * 2.43 * 0.85)
    at = -p / 2 + np.sqrt(p * p / 4 - q)
    light = reference @ [0.2126, 0.7152, 0.0722]
    start, stop = np.log2(at / light.max()), np.log2(at / np.median(light))
    count = max(2, int(np.ceil(stop - start)))
    return np.max([ldr(curve(2 ** e * reference), curve(2 ** e * test))
                   for e in np.linspace(start, stop, count)], axis=0)


def decoded(codes):
    v = np.asarray(codes) / 255
    return np.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4)
