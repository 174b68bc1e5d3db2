# SPDX-License-Identifier: BSD-3-Clause
"""HIC and channel filters against closed forms and the corridor of SAE J211-1."""
import math
import unittest

import numpy

import crumple


class HicTest(unittest.TestCase):
    def test_constant_acceleration_fills_the_window(self):
        # The mean is a for any window, so the longest one counts: HIC = window a^2.5; also one that is no multiple of dt.
        t = numpy.linspace(0, 0.1, 1001)
        for window in (0.015, 0.036, 0.01505):
            self.assertAlmostEqual(crumple.hic(t, numpy.full(1001, 60.0), window) / (window * 60.0**2.5), 1.0, 9)

    def test_square_pulse_shorter_than_the_window(self):
        # HIC = T A^2.5: a longer window only lowers it.
        t = numpy.linspace(0, 0.05, 5001)
        pulse = numpy.zeros(5001)
        pulse[2000:3001] = 100.0
        self.assertAlmostEqual(crumple.hic(t, pulse, 0.015) / (0.010 * 100.0**2.5), 1.0, 9)

    def test_half_sine(self):
        # C.C. Chou, G.W. Nyquist, Analytical Studies of the Head Injury Criterion (HIC), SAE 740082 (1974): 0.4146 T A^2.5.
        # By symmetry the window is centred. With u = pi w / (2 T) its mean is A sin(u) / u, so that HIC is
        # (2 T / pi) A^2.5 u^-1.5 sin(u)^2.5, largest where tan(u) = 5 u / 3.
        u = 1.0
        for _ in range(100):
            u = math.atan(5 * u / 3)
        closed = 2 / math.pi * u**-1.5 * math.sin(u) ** 2.5
        self.assertAlmostEqual(closed, 0.4146, 4)
        for duration in (0.010, 0.020):
            t = numpy.linspace(0, duration, 3001)
            pulse = 150.0 * numpy.sin(math.pi * t / duration)
            self.assertAlmostEqual(crumple.hic(t, pulse, 0.036) / (closed * duration * 150.0**2.5), 1.0, 6)

    def test_half_sine_longer_than_the_window(self):
        # The window is the longest one: w (A 2 T / (pi w) sin(pi w / (2 T)))^2.5.
        duration, window, peak = 0.060, 0.015, 80.0
        t = numpy.linspace(0, duration, 2401)
        mean = peak * 2 * duration / (math.pi * window) * math.sin(math.pi * window / (2 * duration))
        found = crumple.hic(t, peak * numpy.sin(math.pi * t / duration), window)
        self.assertAlmostEqual(found / (window * mean**2.5), 1.0, 6)

    def test_triangular_pulse(self):
        # Centred window of the share k of T: mean A (1 - k/2), HIC = T A^2.5 k (1 - k/2)^2.5, largest for k = 4/7.
        closed = 4 / 7 * (5 / 7) ** 2.5
        t = numpy.linspace(0, 0.012, 2001)
        pulse = 200.0 * (1 - numpy.abs(2 * t / 0.012 - 1))
        self.assertAlmostEqual(crumple.hic(t, pulse, 0.036) / (closed * 0.012 * 200.0**2.5), 1.0, 5)

    def test_uneven_times_and_brute_force(self):
        random = numpy.random.default_rng(5)
        t = numpy.cumsum(random.uniform(0.0002, 0.001, 80))
        a = random.uniform(0, 100, 80)
        integral = numpy.concatenate([[0], numpy.cumsum(0.5 * (a[1:] + a[:-1]) * numpy.diff(t))])
        best = 0.0
        for i in range(80):
            for j in range(i + 1, 80):
                if t[j] - t[i] <= 0.015:
                    best = max(best, (t[j] - t[i]) * ((integral[j] - integral[i]) / (t[j] - t[i])) ** 2.5)
        found = crumple.hic(t, a, 0.015)
        self.assertGreaterEqual(found, best * (1 - 1e-12))
        self.assertLess(found, best * 1.05)  # windows may begin between samples, too

    def test_hic36_is_never_below_hic15(self):
        t = numpy.linspace(0, 0.1, 1001)
        a = 50 + 30 * numpy.sin(80 * t) ** 2
        self.assertGreater(crumple.hic(t, a, 0.036), crumple.hic(t, a, 0.015))

    def test_wrong_input(self):
        with self.assertRaises(ValueError):
            crumple.hic([0, 1], [1, 2, 3])
        with self.assertRaises(ValueError):
            crumple.hic([0, 0], [1, 2])
        with self.assertRaises(ValueError):
            crumple.hic([0, 1], [1, 2], window=0)
        self.assertEqual(crumple.hic([0, 0.001], [0, 0]), 0.0)


class FilterTest(unittest.TestCase):
    def gain(self, cfc, frequency, rate):
        """Of a long sine wave, in the middle of it."""
        t = numpy.arange(int(rate * (20 / frequency + 20 / cfc))) / rate
        _, filtered = crumple.cfc_filter(t, numpy.sin(2 * math.pi * frequency * t), cfc)
        middle = slice(len(t) // 4, 3 * len(t) // 4)
        wave = numpy.exp(2j * math.pi * frequency * t[middle])
        periods = int(len(wave) * frequency / rate)
        count = round(periods * rate / frequency)
        return 2 * abs(numpy.vdot(wave[:count], filtered[middle][:count])) / count

    def test_gain_is_the_closed_form(self):
        for cfc in (60, 180, 600, 1000):
            rate = 10.0 * 1000 * cfc / 100
            for ratio in (0.25, 0.5, 1.0, 5 / 3, 3.0):
                closed = 1 / (1 + (math.tan(math.pi * ratio * cfc / rate) / math.tan(math.pi * 2.0775 * cfc / rate)) ** 4)
                self.assertAlmostEqual(self.gain(cfc, ratio * cfc, rate), closed, 3)

    def test_gain_is_in_the_corridor_of_the_standard(self):
        # SAE J211-1, figure 1: +-0.5 dB far below the class, +0.5/-1 dB at it, +0.5/-4 dB at 1.65 times it.
        for cfc in (60, 180, 600, 1000):
            rate = 100.0 * cfc
            for ratio, low, high in ((0.2, -0.5, 0.5), (0.6, -0.5, 0.5), (1.0, -1.0, 0.5), (1.65, -4.0, 0.5)):
                decibels = 20 * math.log10(self.gain(cfc, ratio * cfc, rate))
                self.assertGreaterEqual(decibels, low, (cfc, ratio))
                self.assertLessEqual(decibels, high, (cfc, ratio))

    def test_there_is_no_phase_and_no_change_of_lines(self):
        t = numpy.linspace(0, 0.1, 2001)
        pulse = numpy.exp(-(((t - 0.05) / 0.004) ** 2))
        _, filtered = crumple.cfc_filter(t, pulse, 180)
        self.assertEqual(numpy.argmax(filtered), 1000)
        numpy.testing.assert_allclose(filtered, filtered[::-1], atol=1e-6)
        _, line = crumple.cfc_filter(t, 3.0 * t - 1.0, 60)
        numpy.testing.assert_allclose(line, 3.0 * t - 1.0, atol=1e-6)

    def test_units_of_time_and_uneven_samples(self):
        t = numpy.linspace(0, 0.1, 2001)
        pulse = numpy.exp(-(((t - 0.05) / 0.004) ** 2))
        _, seconds = crumple.cfc_filter(t, pulse, 60)
        even, milliseconds = crumple.cfc_filter(1000 * t, pulse, 60, seconds=1e-3)
        numpy.testing.assert_allclose(milliseconds, seconds, atol=1e-12)
        self.assertEqual(even[-1], 100.0)

    def test_too_few_samples_are_an_error(self):
        with self.assertRaisesRegex(ValueError, "1000"):
            crumple.cfc_filter(numpy.linspace(0, 1, 100), numpy.zeros(100), 1000)
        with self.assertRaises(ValueError):
            crumple.cfc_filter(numpy.array([0.0, 1.0]), numpy.zeros(2), 60)


if __name__ == "__main__":
    unittest.main()
