package tellosimulator.report;

import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tellosimulator.comparison.FlightComparison.Flight;
import tellosimulator.recording.ReportedState;

/** Charts of two flights as SVG markup, with one line for each flight. Immutable. */
final class ComparisonCharts {

  /** Width of the drawing, which the browser scales. */
  private static final int WIDTH = 1000;

  private static final int HEIGHT = 100;

  /** Maximum number of points in a line. Decided: several for each pixel. */
  private static final int MOST_POINTS = 4_000;

  private final Flight first;
  private final Flight second;
  private final ReportTexts texts;

  ComparisonCharts(Flight first, Flight second, ReportTexts texts) {
    this.first = first;
    this.second = second;
    this.texts = texts;
  }

  String markup() {
    return chart("comparison.height", "cm", ReportedState::heightCm)
        + chart("comparison.yaw", "°", ReportedState::yawDeg)
        + chart("comparison.speed", "cm/s", state -> 100 * state.velocity().norm());
  }

  private String chart(String key, String unit, ToDoubleFunction<ReportedState> value) {
    DoubleStream values =
        Stream.of(first, second).flatMap(flight -> flown(flight).stream()).mapToDouble(value);
    double[] sorted = values.sorted().toArray();
    double low = sorted.length == 0 ? 0 : sorted[0];
    double high = sorted.length == 0 ? 0 : sorted[sorted.length - 1];
    double span = Math.max(1, high - low);
    String label = texts.of(key);
    String least = Math.round(low) + " " + unit;
    String most = Math.round(high) + " " + unit;
    ToDoubleFunction<ReportedState> down =
        state -> HEIGHT * (1 - (value.applyAsDouble(state) - low) / span);
    return "<div class=\"chart\"><div class=\"label\">"
        + HtmlTemplate.escaped(label)
        + "</div><svg viewBox=\"0 0 1000 100\" preserveAspectRatio=\"none\" role=\"img\" aria-label=\""
        + HtmlTemplate.escaped(texts.of("comparison.chart-words", label, least, most))
        + "\">"
        + line("", first, down)
        + line("second", second, down)
        + "</svg><div class=\"range\"><span>"
        + HtmlTemplate.escaped(most)
        + "</span><span>"
        + HtmlTemplate.escaped(least)
        + "</span></div></div>";
  }

  private String line(String kind, Flight flight, ToDoubleFunction<ReportedState> down) {
    double seconds = Math.max(1, Math.max(length(first), length(second)));
    List<ReportedState> flown = flown(flight);
    int stride = 1 + flown.size() / MOST_POINTS;
    String points =
        IntStream.range(0, flown.size())
            .filter(i -> i % stride == 0)
            .mapToObj(flown::get)
            .map(
                state ->
                    String.format(
                        Locale.ROOT,
                        "%.1f,%.1f",
                        WIDTH * (state.time() - flight.recording().run().started()) / seconds,
                        down.applyAsDouble(state)))
            .collect(Collectors.joining(" "));
    return "<polyline class=\"" + kind + "\" points=\"" + points + "\"/>";
  }

  /** Returns the first drone's states from its takeoff on. */
  private static List<ReportedState> flown(Flight flight) {
    double started = flight.recording().run().started();
    return flight.states().stream()
        .filter(state -> state.drone() == 1 && state.time() >= started)
        .toList();
  }

  private static double length(Flight flight) {
    List<ReportedState> flown = flown(flight);
    return flown.isEmpty()
        ? 0
        : flown.get(flown.size() - 1).time() - flight.recording().run().started();
  }
}
