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
 * Charts of height, speed and battery: beside each other where there is little room, and below each
 * other where there is more. Each drone's last minute is kept, so that choosing another drone shows
 * its own. Of use once motors have run. For the JavaFX thread.
 */
final class ChartPanel extends Card {

  /** Least time between two drawings [ns]. Decided: ten a second look alive. */
  private static final long PERIOD_NANOS = 100_000_000;

  private static final double GAP = 6;

  /** Height of charts beside each other, at least and where there is room [px]. */
  private static final double LEAST_ROW = 52;

  private static final double ROW = 110;

  /** A chart that stands on its own is this high at least, and at the most [px]. */
  private static final double LEAST_ALONE = 64;

  private static final double MOST_ALONE = 110;

  /** What is kept of a drone. */
  private record History(TimeSeries height, TimeSeries speed, TimeSeries battery) {

    static History empty() {
      return new History(new TimeSeries(), new TimeSeries(), new TimeSeries());
    }

    /** Moment of the newest sample [s]. */
    double newest() {
      return height.time(height.size() - 1);
    }

    void add(FxDroneModel drone, double seconds) {
      height.add(seconds, drone.zCmProperty().get());
      speed.add(seconds, drone.speedCmProperty().get());
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
    context.pulse().onBeat(this::beat);
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
    if (clock.due(nanos) && isOpen() && !drawn) {
      clock.take(nanos);
      drawnDrone = simulation.selected().number();
      drawnSeconds = shown.newest();
      height.show(shown.height(), drawnSeconds);
      speed.show(shown.speed(), drawnSeconds);
      battery.show(shown.battery(), drawnSeconds);
    }
  }

  /** Open, it takes what nobody else needs. */
  @Override
  protected double computeMaxHeight(double width) {
    double more = isOpen() ? row.maxHeight(width) - row.prefHeight(width) : 0;
    return computePrefHeight(width) + more;
  }

  /** The charts, as there is room for them. */
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

    /** The charge, which hardly changes in a minute, has least; the others share the rest. */
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
