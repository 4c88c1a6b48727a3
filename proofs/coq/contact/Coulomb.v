(** Contact problems with dry friction, over Coq's real numbers (FORMAT.md, "The problem"). *)
From Coq Require Import Reals List.
Local Open Scope R_scope.

(** f 0 + ... + f (n - 1) *)
Fixpoint sum (n : nat) (f : nat -> R) : R := match n with O => 0 | S m => sum m f + f m end.

(** w = A x + c. The first components of x are free, and their rows of w are 0; then, for each contact, the components of
    its force in x and of its velocity in w, normal first. *)
Record problem := Problem {
  dimension : nat;  (* of each contact: 1, 2 or 3 *)
  free : nat;
  contacts : nat;
  friction : nat -> R;  (* of each contact *)
  matrix : nat -> nat -> R;
  constant : nat -> R
}.

Definition size (p : problem) : nat := free p + dimension p * contacts p.

Definition motion (p : problem) (x : nat -> R) (i : nat) : R :=
  sum (size p) (fun j => matrix p i j * x j) + constant p i.

(** The components of a vector that are those of contact k: 0 is the normal one, 1 and 2 are tangential. *)
Definition of_contact (p : problem) (k : nat) (v : nat -> R) (t : nat) : R := v (free p + dimension p * k + t)%nat.

(** |v_T| of a vector of d components *)
Definition tangential (d : nat) (v : nat -> R) : R := sqrt (sum (d - 1) (fun t => v (S t) * v (S t))).

(** Coulomb's law for a force r and a velocity u: neither pulls nor goes in; presses only where it is closed; the force is in
    the cone; and where it slides, the force is at the cone's border and opposite to the sliding. *)
Record coulomb (d : nat) (mu : R) (r u : nat -> R) : Prop := Coulomb {
  no_pull : 0 <= r 0%nat;
  no_overlap : 0 <= u 0%nat;
  closed_or_free : r 0%nat * u 0%nat = 0;
  in_cone : tangential d r <= mu * r 0%nat;
  opposite : forall t, (1 <= t < d)%nat -> tangential d u * r t = - (mu * r 0%nat) * u t
}.

Definition solution (p : problem) (x : nat -> R) : Prop :=
  (forall i, (i < free p)%nat -> motion p x i = 0) /\
  forall k, (k < contacts p)%nat ->
    coulomb (dimension p) (friction p k) (of_contact p k x) (of_contact p k (motion p x)).

(** What is known of the numbers of a problem; in dimension 1 there is no friction. *)
Definition proper (p : problem) : Prop :=
  (1 <= dimension p <= 3)%nat /\
  forall k, (k < contacts p)%nat -> 0 <= friction p k /\ (dimension p = 1%nat -> friction p k = 0).

(** The modes of a contact. *)
Inductive mode := Open | Touch | Stick | Slide | SlidePlus | SlideMinus.

Definition in_mode (d : nat) (mu : R) (m : mode) (r u : nat -> R) : Prop :=
  match m with
  | Open => forall t, (t < d)%nat -> r t = 0
  | Touch => u 0%nat = 0 /\ forall t, (t < d)%nat -> r t = 0
  | Stick => u 0%nat = 0 /\ (mu <> 0 -> forall t, (t < d)%nat -> u t = 0)
  | Slide => u 0%nat = 0 /\ tangential d r = mu * r 0%nat
  | SlidePlus => u 0%nat = 0 /\ d = 2%nat /\ r 1%nat = - (mu * r 0%nat) /\ 0 <= u 1%nat
  | SlideMinus => u 0%nat = 0 /\ d = 2%nat /\ r 1%nat = mu * r 0%nat /\ u 1%nat <= 0
  end.

(** What the claims of a certificate say of a problem and of an answer to it, a vector (FORMAT.md, "Claims"). *)
Definition near (n : nat) (distance : R) (x y : nat -> R) : Prop := forall i, (i < n)%nat -> Rabs (x i - y i) <= distance.

Definition with_constant (p : problem) (c : nat -> R) : problem :=
  Problem (dimension p) (free p) (contacts p) (friction p) (matrix p) c.

(** A problem whose constant is near has a solution that is near. *)
Definition eps (p : problem) (answer : nat -> R) (bound moved : R) : Prop :=
  exists c x, near (size p) bound c (constant p) /\ near (size p) moved x answer /\ solution (with_constant p c) x.

(** There is a solution near the answer, in these modes. *)
Definition enclosure (p : problem) (answer : nat -> R) (rho : R) (modes : nat -> mode) : Prop :=
  exists x, solution p x /\ near (size p) rho x answer /\
    forall k, (k < contacts p)%nat ->
      in_mode (dimension p) (friction p k) (modes k) (of_contact p k x) (of_contact p k (motion p x)).

(** The same, and its velocities are near those of the answer. *)
Definition enclosure_with_velocities (p : problem) (answer : nat -> R) (rho eta : R) (modes : nat -> mode) : Prop :=
  exists x, solution p x /\ near (size p) rho x answer /\
    (forall k, (k < contacts p)%nat ->
      in_mode (dimension p) (friction p k) (modes k) (of_contact p k x) (of_contact p k (motion p x))) /\
    forall i, (free p <= i < size p)%nat -> Rabs (motion p x i - motion p answer i) <= eta.

Definition none_within (p : problem) (answer : nat -> R) (rho : R) : Prop :=
  forall x, near (size p) rho x answer -> ~ solution p x.

Definition no_solution (p : problem) : Prop := forall x, ~ solution p x.

(** Forces that hold what the problem describes at rest: its first unknowns, accelerations, are 0, and nothing is left of w. *)
Record at_rest (p : problem) (accelerations : nat) (x : nat -> R) : Prop := AtRest {
  no_acceleration : forall i, (i < accelerations)%nat -> x i = 0;
  balanced : forall i, (i < size p)%nat -> motion p x i = 0;
  within_cones : forall k, (k < contacts p)%nat ->
    0 <= of_contact p k x 0%nat /\ tangential (dimension p) (of_contact p k x) <= friction p k * of_contact p k x 0%nat
}.

Definition can_rest (p : problem) (accelerations : nat) : Prop := exists x, at_rest p accelerations x.
Definition cannot_rest (p : problem) (accelerations : nat) : Prop := forall x, ~ at_rest p accelerations x.

(** Exactly one solution, whatever the constant. *)
Definition unique (p : problem) : Prop :=
  forall c, exists x, solution (with_constant p c) x /\
    forall y, solution (with_constant p c) y -> forall i, (i < size p)%nat -> y i = x i.

(** A motion in a list of all: the box of its forces, its modes, and how far from the velocities in the box others may be;
    without a distance it is the only one of its kind. Components are those of contacts, without the free ones. *)
Record listed_motion := ListedMotion {
  box_center : nat -> R;
  box_radius : nat -> R;
  listed_modes : option (nat -> mode);
  distance : option (nat -> R)
}.

Definition in_box (p : problem) (m : listed_motion) (x : nat -> R) : Prop :=
  (forall i, (i < free p)%nat -> motion p x i = 0) /\
  forall j, (j < dimension p * contacts p)%nat -> Rabs (x (free p + j)%nat - box_center m j) <= box_radius m j.

Definition is_listed (p : problem) (m : listed_motion) (x : nat -> R) : Prop :=
  solution p x /\ in_box p m x /\ forall modes k, listed_modes m = Some modes -> (k < contacts p)%nat ->
    in_mode (dimension p) (friction p k) (modes k) (of_contact p k x) (of_contact p k (motion p x)).

(** A solution has the velocities of a motion that was found; or, where that has a distance, each of its velocities is within
    this distance of one that forces in the box give. *)
Definition is_near (p : problem) (m : listed_motion) (found x : nat -> R) : Prop :=
  forall j, (j < dimension p * contacts p)%nat ->
    match distance m with
    | None => motion p x (free p + j)%nat = motion p found (free p + j)%nat
    | Some e => exists y, in_box p m y /\ Rabs (motion p x (free p + j)%nat - motion p y (free p + j)%nat) <= e j
    end.

(** The motions in the list exist, and each solution is near one of them. *)
Definition all_motions (p : problem) (l : list listed_motion) : Prop :=
  exists found : nat -> nat -> R,
    (forall i m, nth_error l i = Some m -> is_listed p m (found i)) /\
    forall x, solution p x -> exists i m, nth_error l i = Some m /\ is_near p m (found i) x.
