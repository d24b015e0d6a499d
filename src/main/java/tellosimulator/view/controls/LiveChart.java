package tellosimulator.view.controls;

import java.util.ArrayList;
import java.util.List;
import javafx.beans.value.ObservableValue;
import javafx.scene.AccessibleAttribute;
import javafx.scene.control.Label;
import javafx.scene.layout.Region;
import javafx.scene.shape.Line;
import javafx.scene.shape.Polygon;
import javafx.scene.shape.Polyline;
import javafx.scene.shape.Rectangle;

/**
 * A small chart of the last minute of simulated time. For the JavaFX thread.
 *
 * <p>Its owner shows a {@link TimeSeries} as often as it likes, but few times a second are enough.
 */
final class LiveChart extends Region {

  private static final double TITLE_HEIGHT = 16;
  private static final double AXIS_HEIGHT = 15;

  /** A lower chart has no axis, but more of the curve [px]. Decided. */
  private static final double LEAST_WITH_AXIS = 80;

  private final Label title = new Label();
  private final Label highest = new Label();
  private final Label oldest = new Label();
  private final Label newest = new Label();
  private final Rectangle plot = new Rectangle();
  private final Line half = new Line();
  private final Polygon area = new Polygon();
  private final Polyline curve = new Polyline();
  private final double leastTop;
  private double top;
  private TimeSeries samples = new TimeSeries();
  private double nowSeconds;

  /**
   * @param leastTop smallest value at the top of the scale, which grows when it must
   */
  LiveChart(String id, ObservableValue<String> caption, double leastTop) {
    this.leastTop = leastTop;
    this.top = leastTop;
    title.textProperty().bind(caption);
    setId(id);
    initializeSelf();
    initializeParts();
    layoutParts();
  }

  private void initializeSelf() {
    getStyleClass().add("live-chart");
    setMinSize(60, 44);
    setPrefSize(76, 66);
  }

  private void initializeParts() {
    title.getStyleClass().add("caption");
    List.of(highest, oldest, newest).forEach(label -> label.getStyleClass().add("axis-text"));
    oldest.setText("\u2212" + NumberText.whole(TimeSeries.SPAN) + " s");
    newest.setText("0");
    highest.setText(NumberText.whole(top));
    plot.getStyleClass().add("plot");
    half.getStyleClass().add("gridline");
    area.getStyleClass().add("area");
    curve.getStyleClass().add("curve");
    List.of(plot, half, area, curve).forEach(shape -> shape.setManaged(false));
  }

  private void layoutParts() {
    getChildren().addAll(plot, half, area, curve, highest, title, oldest, newest);
  }

  /** Names the moment at the right edge. */
  void setNewest(ObservableValue<String> text) {
    newest.textProperty().bind(text);
  }

  /**
   * Shows samples.
   *
   * @param seconds the moment at the right edge, in simulated time [s]
   */
  void show(TimeSeries ring, double seconds) {
    samples = ring;
    nowSeconds = seconds;
    double needed = ring.largest(seconds);
    double newTop = needed > leastTop ? NiceNumber.atLeast(needed) : leastTop;
    if (newTop != top) {
      top = newTop;
      highest.setText(NumberText.whole(top));
    }
    draw();
  }

  private void draw() {
    double width = plot.getWidth();
    List<Double> points = new ArrayList<>(2 * samples.size() + 4);
    for (int i = 0; i < samples.size(); i++) {
      double age = nowSeconds - samples.time(i);
      if (age <= TimeSeries.SPAN) {
        points.add(plot.getX() + width * (1 - Math.max(0, age) / TimeSeries.SPAN));
        points.add(y(samples.value(i)));
      }
    }
    curve.getPoints().setAll(points);
    if (!points.isEmpty()) {
      double left = points.get(0);
      double right = points.get(points.size() - 2);
      points.addAll(List.of(right, y(0), left, y(0)));
    }
    area.getPoints().setAll(points);
  }

  private double y(double value) {
    double share = Math.max(0, Math.min(1, value / top));
    return plot.getY() + plot.getHeight() - 1 - share * (plot.getHeight() - 2);
  }

  @Override
  protected void layoutChildren() {
    double width = getWidth();
    boolean axis = getHeight() >= LEAST_WITH_AXIS;
    oldest.setVisible(axis);
    newest.setVisible(axis);
    double bottom = getHeight() - (axis ? AXIS_HEIGHT : 0);
    plot.setY(TITLE_HEIGHT);
    plot.setWidth(width);
    plot.setHeight(Math.max(4, bottom - TITLE_HEIGHT));
    double middle = Math.round(plot.getY() + plot.getHeight() / 2) + 0.5;
    half.setStartX(1);
    half.setEndX(width - 1);
    half.setStartY(middle);
    half.setEndY(middle);
    title.resizeRelocate(0, -1, width, TITLE_HEIGHT);
    double high = highest.prefWidth(-1);
    highest.resizeRelocate(3, TITLE_HEIGHT + 1, high, AXIS_HEIGHT);
    oldest.resizeRelocate(0, bottom, oldest.prefWidth(-1), AXIS_HEIGHT);
    double wide = newest.prefWidth(-1);
    newest.resizeRelocate(width - wide, bottom, wide, AXIS_HEIGHT);
    draw();
  }

  @Override
  public Object queryAccessibleAttribute(AccessibleAttribute attribute, Object... parameters) {
    if (attribute == AccessibleAttribute.TEXT) {
      return title.getText();
    }
    return super.queryAccessibleAttribute(attribute, parameters);
  }
}
