package tellosimulator.view.log;

import atlantafx.base.controls.CustomTextField;
import atlantafx.base.controls.Spacer;
import atlantafx.base.theme.Styles;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.stream.IntStream;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.value.ObservableNumberValue;
import javafx.beans.value.ObservableStringValue;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.text.Font;
import javafx.util.StringConverter;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/** What one can do with the log. For the JavaFX thread. */
final class LogToolbar extends HBox {

  /** What the buttons do. */
  record Actions(Runnable clear, Runnable copy, Runnable save, Runnable fold) {}

  private static final LogLevel FIRST_LEVEL = LogLevel.INFO;

  /** In the choice of drones, all of them. */
  private static final Integer ALL = 0;

  /** Width below which buttons are icons [px]. Measured: everything with words, in German. */
  private static final double NARROW = 1180;

  private final Language language;
  private final Messages messages;
  private final Actions actions;
  private final ObservableNumberValue found;
  private final Label title = new Label();
  private final ChoiceBox<LogLevel> level = new ChoiceBox<>();
  private final ChoiceBox<Integer> drone = new ChoiceBox<>();
  private final CustomTextField search = new CustomTextField();
  private final Button clearSearch = new Button(null, new FontIcon(Feather.X));
  private final Label matches = new Label();
  private final ToggleButton timeStamps = new ToggleButton(null, new FontIcon(Feather.CLOCK));
  private final ToggleButton autoscroll =
      new ToggleButton(null, new FontIcon(Feather.CHEVRONS_DOWN));
  private final Button copy = new Button(null, new FontIcon(Feather.COPY));
  private final Button save = new Button(null, new FontIcon(Feather.SAVE));
  private final Button clear = new Button(null, new FontIcon(Feather.TRASH));
  private final Button fold = new Button(null, new FontIcon(Feather.CHEVRON_DOWN));

  private final ObservableValue<ContentDisplay> display =
      widthProperty()
          .map(
              width ->
                  width.doubleValue() < NARROW ? ContentDisplay.GRAPHIC_ONLY : ContentDisplay.LEFT);

  private final ReportButton report;

  /**
   * @param drones how many there are
   * @param found how many rows are shown
   */
  LogToolbar(Language language, int drones, Actions actions, ObservableNumberValue found) {
    this.language = language;
    this.messages = language.messages(LogToolbar.class);
    this.actions = actions;
    this.found = found;
    report = new ReportButton(messages, "log-report", display);
    drone.getItems().add(ALL);
    IntStream.rangeClosed(1, drones).forEach(drone.getItems()::add);
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  /** The least level that is to be shown. */
  ObjectProperty<LogLevel> levelProperty() {
    return level.valueProperty();
  }

  /** Which drone shown lines are about; empty for all. */
  ObservableValue<OptionalInt> droneProperty() {
    return drone
        .valueProperty()
        .map(number -> number.equals(ALL) ? OptionalInt.empty() : OptionalInt.of(number));
  }

  /** What shown lines shall contain; empty for all lines. */
  ObservableStringValue searchProperty() {
    return search.textProperty();
  }

  BooleanProperty timeStampsProperty() {
    return timeStamps.selectedProperty();
  }

  BooleanProperty autoscrollProperty() {
    return autoscroll.selectedProperty();
  }

  /** The font of the log at the scale that is chosen for the window. */
  ReadOnlyObjectProperty<Font> fontProperty() {
    return title.fontProperty();
  }

  /** Lets one type what to search. */
  void startSearch() {
    search.requestFocus();
    search.selectAll();
  }

  /** Lets one open the report of the last flight, from now on. */
  void offer(ReportOffer offer) {
    report.offer(offer);
  }

  private void initializeSelf() {
    getStyleClass().add("log-toolbar");
    setAlignment(Pos.CENTER_LEFT);
    setMinWidth(0); // or words would keep the window wide, and never become icons
  }

  private void initializeParts() {
    title.getStyleClass().add("log-title");
    level.setId("log-level");
    level.getItems().setAll(LogLevel.DEBUG, LogLevel.INFO, LogLevel.WARN, LogLevel.ERROR);
    level.setValue(FIRST_LEVEL);
    drone.setId("log-drone");
    drone.setValue(ALL);
    drone.setVisible(drone.getItems().size() > 2);
    drone.setManaged(drone.isVisible());
    search.setId("log-search");
    search.setLeft(new FontIcon(Feather.SEARCH));
    search.setRight(clearSearch);
    clearSearch.setId("log-search-clear");
    clearSearch.getStyleClass().addAll(Styles.FLAT, "log-search-clear");
    matches.setId("log-matches");
    matches.getStyleClass().add("log-matches");
    initializeButton(timeStamps, "timestamps");
    initializeButton(autoscroll, "autoscroll");
    initializeButton(copy, "copy");
    initializeButton(save, "save");
    initializeButton(clear, "clear");
    initializeButton(fold, "fold");
    fold.contentDisplayProperty().unbind();
    fold.setContentDisplay(ContentDisplay.GRAPHIC_ONLY);
    timeStamps.setSelected(true);
    autoscroll.setSelected(true);
  }

  private void initializeButton(ButtonBase button, String name) {
    button.setId("log-" + name);
    button.getStyleClass().addAll(Styles.SMALL);
    button.textProperty().bind(messages.text(name));
    button.contentDisplayProperty().bind(display);
    Tooltips.install(button, messages.text(name + ".tooltip"));
  }

  private void layoutParts() {
    for (Node fixed :
        new Node[] {title, level, drone, report, timeStamps, autoscroll, copy, save, clear, fold}) {
      ((Region) fixed).setMinWidth(USE_PREF_SIZE);
    }
    getChildren()
        .addAll(
            title,
            level,
            drone,
            search,
            matches,
            new Spacer(),
            report,
            timeStamps,
            autoscroll,
            copy,
            save,
            clear,
            fold);
  }

  private void setupEventHandlers() {
    clearSearch.setOnAction(action -> search.clear());
    search.addEventHandler(
        KeyEvent.KEY_PRESSED,
        event -> {
          if (event.getCode() == KeyCode.ESCAPE && !search.getText().isEmpty()) {
            search.clear();
            event.consume();
          }
        });
    copy.setOnAction(action -> actions.copy().run());
    save.setOnAction(action -> actions.save().run());
    clear.setOnAction(action -> actions.clear().run());
    fold.setOnAction(action -> actions.fold().run());
    language
        .localeProperty()
        .subscribe(
            locale -> {
              level.setConverter(named(value -> messages.now("level." + value.key())));
              drone.setConverter(named(this::droneName));
            });
  }

  private String droneName(Integer number) {
    return number.equals(ALL) ? messages.now("drone.all") : messages.now("drone.one", number);
  }

  private static String matchesKey(int count) {
    return count == 0 ? "matches-none" : count == 1 ? "matches-one" : "matches";
  }

  private void setupBindings() {
    title.textProperty().bind(messages.text("title"));
    search.promptTextProperty().bind(messages.text("search"));
    clearSearch.visibleProperty().bind(search.textProperty().isNotEmpty());
    matches
        .textProperty()
        .bind(found.flatMap(count -> messages.text(matchesKey(count.intValue()), count)));
    matches.visibleProperty().bind(search.textProperty().isNotEmpty());
    Tooltips.install(level, messages.text("level.tooltip"));
    Tooltips.install(drone, messages.text("drone.tooltip"));
    level.accessibleTextProperty().bind(messages.text("level.tooltip"));
    drone.accessibleTextProperty().bind(messages.text("drone.tooltip"));
    search.accessibleTextProperty().bind(messages.text("search"));
    clearSearch.accessibleTextProperty().bind(messages.text("search.clear"));
  }

  /** The names of what is chosen in the present language. */
  private static <T> StringConverter<T> named(Function<T, String> name) {
    return new StringConverter<>() {
      @Override
      public String toString(T value) {
        return value == null ? "" : name.apply(value);
      }

      @Override
      public T fromString(String typed) {
        throw new UnsupportedOperationException("these are chosen, not typed");
      }
    };
  }
}
