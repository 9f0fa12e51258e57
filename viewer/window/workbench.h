#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "window/file_watch.h"
#include "window/lane.h"
#include "window/results/extras.h"
#include "window/results/model.h"
#include "window/results/rendered.h"
#include "window/results/steps.h"
#include "window/results/story.h"
#include "window/results/structure.h"
#include "window/results/truth.h"
#include "window/state.h"

namespace hsr::window {

/// Which animation is written where; the number tells apart what was asked for twice.
struct GifKey {
  TraceKey trace;
  std::filesystem::path file;
  std::uint64_t number = 0;
  bool operator==(const GifKey&) const = default;
};

/// A file's picture, for a model.
struct FileKey {
  ElsewhereKey elsewhere;
  std::uint64_t model = 0;
  bool operator==(const FileKey&) const = default;
};

/// The viewer without its window: the state, and everything that is computed from it, in threads of its
/// own. Panels change `state` and read the results; update() notices what changed and asks for what is
/// missing. Results stay until newer ones are there, so each says what it is of.
class Workbench {
 public:
  /// `wake` is called from any thread when update() should be called soon.
  Workbench(std::function<void()> wake, int threads);

  State state;
  ChildLimits limits;                            ///< of the command whose pictures are shown
  std::optional<std::filesystem::path> watched;  ///< when it is saved that command is run again

  /// Takes over what is finished and begins what is missing. `seconds` is the time, from any beginning;
  /// `panel` how large a picture fits its place on the screen, in pixels.
  void update(double seconds, Extent panel);
  /// Whether something is still computed or waits for its turn.
  bool busy() const;
  /// Whether update() must be called soon although nobody wakes it.
  bool settling() const { return settling_; }

  /// The scene that is shown; null before the first is loaded.
  std::shared_ptr<const Model> model() const { return model_lane_.result(); }
  /// The camera, size and view that the state asks for. There must be a model.
  Camera camera() const;
  Extent picture_size() const;
  ViewKey view_key() const;
  PictureKey picture_key() const;
  std::string other_name() const;
  /// What makes the picture: the algorithm with its settings, or "program".
  std::string maker_name() const;

  /// Shows the pictures of a file or of a command from now on.
  void show_from(const Elsewhere& elsewhere);
  /// Whether the picture is not made here.
  bool shows_elsewhere() const { return state.show_elsewhere && state.elsewhere; }
  /// Whether it is that of a file, which is read again whenever it changes.
  bool shows_file() const { return shows_elsewhere() && state.elsewhere->kind == Elsewhere::Kind::file; }
  /// The file whose change asks for the picture from elsewhere anew.
  std::optional<std::string> watched_file() const;
  /// Reads the file again, or runs the command again.
  void run_again();
  /// Why there is no picture from there; empty if there is one, or it is on its way.
  std::string elsewhere_problem() const;

  /// The algorithm's picture; maybe of an earlier state.
  std::shared_ptr<const Rendered> picture() const { return picture_lane_.result(); }
  /// Whether it is of the present state, in full size.
  bool picture_is_current() const;
  /// What the picture is compared with, the same; null where that is the exact answer.
  std::shared_ptr<const Rendered> other() const { return other_lane_.result(); }
  /// The exact answer and what it says of the picture; null unless it is of the present state.
  std::shared_ptr<const Truth> truth() const;
  std::shared_ptr<const Judgement> judgement() const;
  /// Why its wrong pixels are wrong, and which blends are; null too where all is right.
  std::shared_ptr<const OrderingFailures> causes() const;
  /// The pixels that show a wrong triangle or, once causes() is there, a wrong blend, row by row.
  std::vector<std::uint32_t> failed_pixels() const;

  /// The story of the pixel that was last asked for by want_story; null unless it is of the present state.
  std::shared_ptr<const Story> story() const;
  /// Says which pixel the panel explains; nothing if none.
  void want_story(const std::optional<glm::ivec2>& pixel) { story_pixel_ = pixel; }

  /// Says whether somebody wants to know what each skip saves.
  void want_skip_times(bool wanted) { want_skip_times_ = wanted; }
  /// Measures it for the present picture although that takes long.
  void measure_skips_patiently() { patient_picture_ = picture_key(); }

  /// The steps of the present picture, the picture after state.step of them, and steps worth going to; null
  /// unless they are of the present state, but for the moment, which may be one of shortly before.
  std::shared_ptr<const Trace> trace() const;
  std::shared_ptr<const Moment> moment() const;
  std::shared_ptr<const Marks> marks() const;
  /// The face that the selected pixel shows; background_id if none.
  std::uint32_t selected_face() const;
  /// How many triangles cover each pixel, by the exact lists; null unless it is of the present view.
  std::shared_ptr<const std::vector<std::uint32_t>> list_lengths() const;
  /// How often the algorithm wrote each pixel; null unless it is of the present picture.
  std::shared_ptr<const std::vector<std::uint32_t>> overdraw() const;
  /// What finds the triangles that rays meet, to be drawn; null unless it is of the present scene.
  std::shared_ptr<const Structure> structure() const;
  /// What each skip saves, in milliseconds; null unless it is of the present picture.
  std::shared_ptr<const SkipTimes> skip_times() const;
  bool measures_skips() const { return skips_lane_.busy(); }

  /// The state with everything said that otherwise follows from the window: what is saved.
  State exact_state() const;

  /// Moves the camera: until it rests, pictures are as coarse as is needed to follow.
  void move_camera(const Camera& camera);
  /// Another scene, from its own camera. A name that does not exist is told by problems().
  void open_scene(const std::string& words);
  void select_algorithm(const AlgorithmSpec& spec);
  /// Drags a corner of a triangle to a place in the world.
  void move_corner(std::uint32_t corner, const glm::vec3& position);

  /// Writes the steps as an animation, in the background; there must be a trace.
  void write_gif(const std::filesystem::path& file);
  /// What became of it, once: the file, or what went wrong.
  std::optional<std::string> gif_news();

  /// Stops all work that is not finished; nothing of it is begun again before something changes.
  void cancel();
  bool cancelled() const;
  /// Begins again what was stopped or has failed.
  void retry();

  /// A running piece of work.
  struct Running {
    std::string what;
    std::string stage;
    double done = 0.0;
    double milliseconds = 0.0;
  };
  std::vector<Running> running() const;
  /// What went wrong with the present state, a line each.
  std::vector<std::string> problems() const;

  int threads() const { return threads_; }
  /// How many pictures were made so far: none while nothing changes.
  std::uint64_t pictures_made() const { return pictures_made_; }

 private:
  Surroundings surroundings() const;
  void fit_panel(Extent panel);
  bool model_is_current() const;
  /// The file's picture: of the present run, or of the one before while the file is read again.
  std::shared_ptr<const FromElsewhere> file() const;
  void watch_file();
  void find_home_camera();
  void want_model();
  /// Calls visit(what, lane) for every lane.
  template <class Self, class Visit>
  static void for_each_lane(Self& self, Visit visit);
  void want_pictures();
  void want_truth();
  void want_causes();
  void want_steps();
  void want_extras();
  void poll_gif();
  StructureKey structure_key() const;
  TraceKey trace_key() const;
  MomentKey moment_key() const;
  MarksKey marks_key() const;
  int coarseness() const;

  int threads_;
  double now_ = 0.0;
  double camera_moved_ = -1.0;  // when
  bool settling_ = false;
  Extent panel_ = {640, 400};
  bool fitted_ = false;  // panel_ is one that was told
  std::uint64_t models_ = 0;
  Camera home_camera_;  // where the scene is seen from at first
  std::pair<std::uint64_t, double> home_of_ = {0,
                                               0.0};  // the model and the ratio of width to height it is for
  std::uint64_t pictures_made_ = 0;
  double full_ms_ = 0.0;  // how long the last picture in full size took

  // A renderer keeps what it prepared, so each lane has its own.
  std::shared_ptr<PreparedRenderers> prepared_ = std::make_shared<PreparedRenderers>();
  std::shared_ptr<PreparedRenderers> other_prepared_ = std::make_shared<PreparedRenderers>();
  std::shared_ptr<PreparedRenderers> skips_prepared_ = std::make_shared<PreparedRenderers>();
  std::shared_ptr<StoryKeeper> story_keeper_ = std::make_shared<StoryKeeper>();
  std::optional<glm::ivec2> story_pixel_;
  bool want_skip_times_ = false;
  std::optional<PictureKey> patient_picture_;
  std::shared_ptr<const Scene> unmoved_;  // the scene as it was read
  std::string unmoved_name_;

  std::uint64_t gifs_ = 0;
  std::uint64_t runs_ = 0;  // how often the picture from elsewhere was asked for anew
  FileWatch watch_;

  Lane<ModelKey, Model> model_lane_;
  Lane<FileKey, FromElsewhere> file_lane_;
  Lane<PictureKey, Rendered> picture_lane_;
  Lane<PictureKey, Rendered> other_lane_;
  Lane<ViewKey, Truth> truth_lane_;
  Lane<PictureKey, Judgement> judgement_lane_;
  Lane<PictureKey, OrderingFailures> causes_lane_;
  Lane<StoryKey, Story> story_lane_;
  Lane<TraceKey, Trace> trace_lane_;
  Lane<MomentKey, Moment> moment_lane_;
  Lane<MarksKey, Marks> marks_lane_;
  Lane<ViewKey, std::vector<std::uint32_t>> lengths_lane_;
  Lane<PictureKey, std::vector<std::uint32_t>> overdraw_lane_;
  Lane<StructureKey, Structure> structure_lane_;
  Lane<SkipsKey, SkipTimes> skips_lane_;
  Lane<GifKey, std::filesystem::path> gif_lane_;
  std::optional<std::string> gif_news_;
};

}  // namespace hsr::window
