package tellosimulator.view.replay;

import atlantafx.base.controls.Spacer;
import atlantafx.base.theme.Styles;
import java.util.List;
import javafx.collections.FXCollections;
import javafx.collections.ObservableList;
import javafx.collections.transformation.FilteredList;
import javafx.geometry.Pos;
import javafx.scene.control.IndexedCell;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.skin.VirtualFlow;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import tellosimulator.report.ReportEntries;
import tellosimulator.report.ReportEntry;
import tellosimulator.report.ReportTexts;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * The commands of a flight with their replies, and what happened. It follows the moment that is
 * shown; to choose an entry goes to its moment. For the JavaFX thread.
 */
final class EntryList extends VBox {

  /** An entry counts as begun that much before its moment [s]. */
  private static final double NEARLY = 0.005;

  private final FxReplay replay;
  private final Playback playback;
  private final Language language;
  private final Messages messages;
  private final ObservableList<ReportEntry> all = FXCollections.observableArrayList();
  private final FilteredList<ReportEntry> entries = new FilteredList<>(all);
  private final ListView<ReportEntry> list = new ListView<>(entries);
  private final ToggleButton problems = new ToggleButton();
  private boolean following;

  EntryList(FxReplay replay, Language language) {
    this.replay = replay;
    this.playback = replay.playback();
    this.language = language;
    this.messages = language.messages(EntryList.class);
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
  }

  /** The moments at which something went wrong [s]. */
  List<Double> problems() {
    return all.stream().filter(ReportEntry::wrong).map(ReportEntry::time).toList();
  }

  /**
   * Goes to the entry before or after the moment; beyond the last one to the end of the flight.
   *
   * @param step 1 for the next one, -1 for the one before
   */
  void jump(int step) {
    double time = playback.time();
    double edge = step > 0 ? playback.end() : playback.begin();
    double target = edge;
    for (ReportEntry entry : entries) {
      if (step > 0 && entry.time() > time + NEARLY) {
        target = entry.time();
        break;
      }
      if (step < 0 && entry.time() < time - NEARLY) {
        target = entry.time();
      }
    }
    playback.seek(target);
  }

  private void initializeSelf() {
    setId("entries");
    setMinHeight(0);
  }

  private void initializeParts() {
    list.setId("entry-list");
    list.setCellFactory(
        view ->
            new EntryCell(
                view,
                messages,
                replay.simulation().drones().size() > 1,
                entry -> playback.seek(entry.time())));
    list.setPlaceholder(messages.label("no-entries"));
    list.accessibleTextProperty().bind(messages.text("entries"));
    list.setMinHeight(0);
    problems.setId("only-problems");
    problems.getStyleClass().add(Styles.SMALL);
    problems.textProperty().bind(messages.text("only-problems"));
    problems.setMinWidth(USE_PREF_SIZE);
    Tooltips.install(problems, messages.text("only-problems.tooltip"));
  }

  private void layoutParts() {
    Label title = messages.label("entries-title", "heading");
    HBox head = new HBox(title, new Spacer(), problems);
    head.setAlignment(Pos.CENTER_LEFT);
    head.getStyleClass().add("entries-head");
    VBox.setVgrow(list, Priority.ALWAYS);
    getChildren().addAll(head, list);
  }

  private void setupEventHandlers() {
    language.localeProperty().subscribe(locale -> translate());
    problems
        .selectedProperty()
        .subscribe(
            only -> {
              following = true;
              entries.setPredicate(entry -> !only || entry.wrong());
              following = false;
              follow();
            });
    list.getSelectionModel()
        .selectedItemProperty()
        .addListener((property, before, chosen) -> choose(chosen));
    playback.timeProperty().subscribe(this::follow);
  }

  /** The words of entries are made anew in each language. */
  private void translate() {
    following = true;
    ReportTexts texts = new ReportTexts(language.translation());
    all.setAll(new ReportEntries(texts).of(replay.flight().flight()));
    following = false;
    follow();
  }

  private void choose(ReportEntry chosen) {
    if (!following && chosen != null) {
      playback.seek(chosen.time());
    }
  }

  private void follow() {
    if (following) {
      return;
    }
    int index = current();
    if (index == list.getSelectionModel().getSelectedIndex()) {
      return;
    }
    following = true;
    if (index < 0) {
      list.getSelectionModel().clearSelection();
    } else if (!sameMoment(index)) {
      list.getSelectionModel().select(index);
      bringIntoSight(index);
    }
    following = false;
  }

  /** Whether another entry of the same moment is chosen, which then stays so. */
  private boolean sameMoment(int index) {
    ReportEntry chosen = list.getSelectionModel().getSelectedItem();
    return chosen != null && chosen.time() == entries.get(index).time();
  }

  /** The last entry that has begun; -1 before the first one. */
  private int current() {
    double time = playback.time() + NEARLY;
    int low = -1;
    int high = entries.size() - 1;
    while (low < high) {
      int middle = (low + high + 1) / 2;
      if (entries.get(middle).time() <= time) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  private void bringIntoSight(int index) {
    if (list.lookup(".virtual-flow") instanceof VirtualFlow<?> flow) {
      IndexedCell<?> first = flow.getFirstVisibleCell();
      IndexedCell<?> last = flow.getLastVisibleCell();
      boolean seen =
          first != null && first.getIndex() < index && last != null && index < last.getIndex();
      if (!seen) {
        list.scrollTo(Math.max(0, index - 1));
      }
    }
  }
}
