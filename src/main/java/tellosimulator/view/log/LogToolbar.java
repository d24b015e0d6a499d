package tellosimulator.view.log;

import atlantafx.base.controls.CustomTextField;
import atlantafx.base.controls.Spacer;
import atlantafx.base.theme.Styles;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.value.ObservableNumberValue;
import javafx.beans.value.ObservableStringValue;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.text.Font;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/** The bar with the filters and actions of the log. Confined to the JavaFX thread. */
final class LogToolbar extends HBox {

  /** The actions of the buttons. */
  record Actions(Runnable clear, Runnable copy, Runnable save, Runnable fold) {}

  private static final LogLevel FIRST_LEVEL = LogLevel.INFO;

  /** The choice-box item that stands for all drones. */
  private static final Integer ALL = 0;

  /**
   * Width below which buttons have no labels [px]. Measured: the toolbar's width with all labels in
   * German.
   */
  private static final double NARROW = 1180;

  private final Messages messages;
  private final Label title;
  private final ChoiceBox<LogLevel> level = Nodes.named(new ChoiceBox<>(), "log-level");
  private final ChoiceBox<Integer> drone = Nodes.named(new ChoiceBox<>(), "log-drone");
  private final CustomTextField search = Nodes.named(new CustomTextField(), "log-search");
  private final ToggleButton timeStamps = new ToggleButton();
  private final ToggleButton autoscroll = new ToggleButton();

  private final ObservableValue<ContentDisplay> display =
      widthProperty()
          .map(
              width ->
                  width.doubleValue() < NARROW ? ContentDisplay.GRAPHIC_ONLY : ContentDisplay.LEFT);

  private final ReportButton report;

  /**
   * @param drones the number of drones
   * @param found the number of rows that pass the filter
   */
  LogToolbar(Language language, int drones, Actions actions, ObservableNumberValue found) {
    this.messages = language.messages(LogToolbar.class);
    report = new ReportButton(messages, "log-report", display);
    title = messages.label("title", "log-title");
    getStyleClass().add("log-toolbar");
    setAlignment(Pos.CENTER_LEFT);
    setMinWidth(0); // otherwise the labels would keep the window from becoming narrower
    initializeChoices(language, drones);
    initializeSearch();
    layoutParts(actions, found);
  }

  /** The least important level that is shown. */
  ObjectProperty<LogLevel> levelProperty() {
    return level.valueProperty();
  }

  /** The number of the drone whose lines are shown, from 1; empty for all drones. */
  ObservableValue<OptionalInt> droneProperty() {
    return drone
        .valueProperty()
        .map(number -> number.equals(ALL) ? OptionalInt.empty() : OptionalInt.of(number));
  }

  /** The text that visible lines must contain; empty for all lines. */
  ObservableStringValue searchProperty() {
    return search.textProperty();
  }

  BooleanProperty timeStampsProperty() {
    return timeStamps.selectedProperty();
  }

  BooleanProperty autoscrollProperty() {
    return autoscroll.selectedProperty();
  }

  /** The font of the log at the window's scale. */
  ReadOnlyObjectProperty<Font> fontProperty() {
    return title.fontProperty();
  }

  /** Focuses the search field. */
  void startSearch() {
    search.requestFocus();
    search.selectAll();
  }

  /** Shows the button that opens the report of the last flight. */
  void offer(ReportOffer offer) {
    report.offer(offer);
  }

  private void initializeChoices(Language language, int drones) {
    level.getItems().setAll(LogLevel.DEBUG, LogLevel.INFO, LogLevel.WARN, LogLevel.ERROR);
    level.setValue(FIRST_LEVEL);
    drone.getItems().add(ALL);
    IntStream.rangeClosed(1, drones).forEach(drone.getItems()::add);
    drone.setValue(ALL);
    Nodes.setShown(drone, drones > 1);
    Nodes.described(level, messages.text("level.tooltip"));
    Nodes.described(drone, messages.text("drone.tooltip"));
    Nodes.nameItems(
        level, language.localeProperty(), value -> messages.now("level." + value.key()));
    Nodes.nameItems(drone, language.localeProperty(), this::droneName);
  }

  private void initializeSearch() {
    Button clearSearch = new Button("", new FontIcon(Feather.X));
    Nodes.named(clearSearch, "log-search-clear", Styles.FLAT, "log-search-clear");
    clearSearch.accessibleTextProperty().bind(messages.text("search.clear"));
    clearSearch.visibleProperty().bind(search.textProperty().isNotEmpty());
    clearSearch.setOnAction(action -> search.clear());
    search.setLeft(new FontIcon(Feather.SEARCH));
    search.setRight(clearSearch);
    search.promptTextProperty().bind(messages.text("search"));
    search.accessibleTextProperty().bind(messages.text("search"));
    search.addEventHandler(
        KeyEvent.KEY_PRESSED,
        event -> {
          if (event.getCode() == KeyCode.ESCAPE && !search.getText().isEmpty()) {
            search.clear();
            event.consume();
          }
        });
  }

  private void layoutParts(Actions actions, ObservableNumberValue found) {
    Label matches = Nodes.named(new Label(), "log-matches", "log-matches");
    matches
        .textProperty()
        .bind(found.flatMap(count -> messages.text(matchesKey(count.intValue()), count)));
    matches.visibleProperty().bind(search.textProperty().isNotEmpty());
    initializeButton(timeStamps, "timestamps", Feather.CLOCK);
    initializeButton(autoscroll, "autoscroll", Feather.CHEVRONS_DOWN);
    timeStamps.setSelected(true);
    autoscroll.setSelected(true);
    Button fold = button("fold", Feather.CHEVRON_DOWN, actions.fold());
    fold.contentDisplayProperty().unbind();
    fold.setContentDisplay(ContentDisplay.GRAPHIC_ONLY);
    List.of(title, level, drone, report).forEach(Nodes::unshrinkable);
    getChildren().addAll(title, level, drone, search, matches, new Spacer(), report);
    getChildren()
        .addAll(
            timeStamps,
            autoscroll,
            button("copy", Feather.COPY, actions.copy()),
            button("save", Feather.SAVE, actions.save()),
            button("clear", Feather.TRASH, actions.clear()),
            fold);
  }

  private Button button(String name, Feather icon, Runnable action) {
    Button button = new Button();
    initializeButton(button, name, icon);
    button.setOnAction(pressed -> action.run());
    return button;
  }

  private void initializeButton(ButtonBase button, String name, Feather icon) {
    Nodes.named(Nodes.unshrinkable(button), "log-" + name, Styles.SMALL);
    button.setGraphic(new FontIcon(icon));
    button.textProperty().bind(messages.text(name));
    button.contentDisplayProperty().bind(display);
    Tooltips.install(button, messages.text(name + ".tooltip"));
  }

  private String droneName(Integer number) {
    return number.equals(ALL) ? messages.now("drone.all") : messages.now("drone.one", number);
  }

  private static String matchesKey(int count) {
    return count == 0 ? "matches-none" : count == 1 ? "matches-one" : "matches";
  }
}
