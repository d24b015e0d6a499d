package tellosimulator.view.controls;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * A card with charts of height, speed and battery. The charts are side by side if space is short,
 * and otherwise stacked. The last minute of every drone is kept, so that selecting another drone
 * shows its own data. The card counts as useful once the motors of any drone have run. Confined to
 * the JavaFX thread.
 */
final class ChartPanel extends Card {

  /** Minimum time between two drawings [ns]. Decided: ten drawings a second look smooth. */
  private static final long PERIOD_NANOS = 100_000_000;

  private static final double GAP = 6;

  /** Minimum height of charts that are side by side [px]. */
  private static final double LEAST_ROW = 52;

  /** Preferred height of charts that are side by side [px]. */
  private static final double ROW = 110;

  /** Minimum height of a stacked chart [px]. */
  private static final double LEAST_ALONE = 64;

  /** Maximum height of a stacked chart [px]. */
  private static final double MOST_ALONE = 110;

  /** The samples of a drone. */
  private record History(TimeSeries height, TimeSeries speed, TimeSeries battery) {

    static History empty() {
      return new History(new TimeSeries(), new TimeSeries(), new TimeSeries());
    }

    /** Returns the time of the newest sample [s]. */
    double newest() {
      return height.time(height.size() - 1);
    }

    void add(FxDroneModel drone, double seconds) {
      height.add(seconds, drone.zCm());
      speed.add(seconds, drone.speedCm());
      battery.add(seconds, drone.batteryPercentProperty().get());
    }
  }

  private final FxSimulation simulation;
  private final Map<FxDroneModel, History> histories = new HashMap<>();
  private final List<LiveChart> charts = new ArrayList<>();
  private final LiveChart height;
  private final LiveChart speed;
  private final LiveChart battery;
  private final Row row;
  private final DrawingClock clock;
  private int drawnDrone;
  private double drawnSeconds;

  ChartPanel(ViewContext context) {
    super("charts", context.language().messages(ChartPanel.class).text("chart.heading"));
    simulation = context.simulation();
    Messages messages = context.language().messages(ChartPanel.class);
    height = new LiveChart("height-chart", messages.text("chart.height"), 100);
    speed = new LiveChart("speed-chart", messages.text("chart.speed"), 50);
    battery = new LiveChart("battery-chart", messages.text("chart.battery"), 100);
    charts.addAll(List.of(height, speed, battery));
    charts.forEach(chart -> chart.setNewest(messages.text("chart.now")));
    row = new Row();
    row.setId("charts");
    VBox.setVgrow(row, Priority.ALWAYS);
    layoutCard(row);
    setUseful(false); // before the first flight
    clock = new DrawingClock(simulation, PERIOD_NANOS);
    context.ticker().onTick(this::beat);
  }

  private void beat(long nanos) {
    double seconds = simulation.secondsProperty().get();
    for (FxDroneModel drone : simulation.drones()) {
      histories.computeIfAbsent(drone, unknown -> History.empty()).add(drone, seconds);
      if (drone.snapshotProperty().get().state().energy().motorTime() > 0) {
        setUseful(true);
      }
    }
    History shown = histories.get(simulation.selected());
    boolean drawn = shown.newest() == drawnSeconds && drawnDrone == simulation.selected().number();
    if (isOpen() && !drawn && clock.due(nanos)) {
      drawnDrone = simulation.selected().number();
      drawnSeconds = shown.newest();
      height.show(shown.height(), drawnSeconds);
      speed.show(shown.speed(), drawnSeconds);
      battery.show(shown.battery(), drawnSeconds);
    }
  }

  /** Returns a height with which an open card takes the space that the other cards leave. */
  @Override
  protected double computeMaxHeight(double width) {
    double more = isOpen() ? row.maxHeight(width) - row.prefHeight(width) : 0;
    return computePrefHeight(width) + more;
  }

  /** Arranges the charts according to the available space. */
  private final class Row extends Region {

    Row() {
      getChildren().addAll(charts);
    }

    @Override
    protected double computeMinHeight(double width) {
      return LEAST_ROW;
    }

    @Override
    protected double computePrefHeight(double width) {
      return ROW;
    }

    @Override
    protected double computeMaxHeight(double width) {
      return 2 * MOST_ALONE + LEAST_ALONE + 2 * GAP;
    }

    @Override
    protected void layoutChildren() {
      if (getHeight() >= 3 * LEAST_ALONE + 2 * GAP) {
        layoutBelowEachOther();
      } else {
        layoutBesideEachOther();
      }
    }

    /**
     * Stacks the charts. The battery chart gets the minimum height because its value hardly changes
     * in a minute; the other charts share the rest.
     */
    private void layoutBelowEachOther() {
      double each = Math.floor((getHeight() - LEAST_ALONE - 2 * GAP) / 2);
      height.resizeRelocate(0, 0, getWidth(), each);
      speed.resizeRelocate(0, each + GAP, getWidth(), each);
      battery.resizeRelocate(0, 2 * (each + GAP), getWidth(), LEAST_ALONE);
    }

    private void layoutBesideEachOther() {
      double wide = Math.floor((getWidth() - 2 * GAP) / 3);
      for (int i = 0; i < charts.size(); i++) {
        charts.get(i).resizeRelocate(i * (wide + GAP), 0, wide, getHeight());
      }
    }
  }
}
