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
import tellosimulator.view.fx.Nodes;

/**
 * A small chart of a value over the last minute of simulated time. Confined to the JavaFX thread.
 *
 * <p>The owner decides how often to call {@link #show}; a few times a second is enough.
 */
final class LiveChart extends Region {

  private static final double TITLE_HEIGHT = 16;
  private static final double AXIS_HEIGHT = 15;

  /** Height below which the chart has no axis [px]. Decided: the curve needs the space. */
  private static final double LEAST_WITH_AXIS = 80;

  private final Label title = Nodes.styled(new Label(), "caption");
  private final Label highest = new Label();
  private final Label oldest = new Label();
  private final Label newest = new Label();
  private final Rectangle plot = Nodes.styled(new Rectangle(), "plot");
  private final Line half = Nodes.styled(new Line(), "gridline");
  private final Polygon area = Nodes.styled(new Polygon(), "area");
  private final Polyline curve = Nodes.styled(new Polyline(), "curve");
  private final double leastTop;
  private double top;
  private TimeSeries samples = new TimeSeries();
  private double nowSeconds;

  /**
   * @param leastTop the minimum value at the upper end of the scale; the scale grows when necessary
   */
  LiveChart(String id, ObservableValue<String> caption, double leastTop) {
    this.leastTop = leastTop;
    this.top = leastTop;
    title.textProperty().bind(caption);
    Nodes.named(this, id, "live-chart");
    setMinSize(60, 44);
    setPrefSize(76, 66);
    List.of(highest, oldest, newest).forEach(label -> label.getStyleClass().add("axis-text"));
    oldest.setText("\u2212" + NumberText.whole(TimeSeries.SPAN) + " s");
    newest.setText("0");
    highest.setText(NumberText.whole(top));
    List.of(plot, half, area, curve).forEach(shape -> shape.setManaged(false));
    getChildren().addAll(plot, half, area, curve, highest, title, oldest, newest);
  }

  /** Sets the text of the time label at the right edge of the chart. */
  void setNewest(ObservableValue<String> text) {
    newest.textProperty().bind(text);
  }

  /**
   * Shows samples.
   *
   * @param seconds the simulated time at the right edge [s]
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
